#include "fluid/samples.h"

template class std::vector<float, thaum::fluid::SamplesAllocator<float>>;
