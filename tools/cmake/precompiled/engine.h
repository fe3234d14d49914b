// The headers that most sources include, compiled once (thaum_headers_of in tools/cmake/targets.cmake): those
// of the standard library, of GLM and of engine/core. A header that changes every day does not belong here,
// because everything is compiled again after a change.
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/assert.h"
#include "core/bytes.h"
#include "core/error.h"
#include "core/maths.h"
#include "core/random.h"
#include "core/text.h"
#include "core/units.h"
