// Two threads write one number without synchronisation. A test expects that the thread sanitizer reports
// this, so that no build or setting can disable the sanitizer unnoticed.
#include <cstdio>
#include <thread>

namespace {

int number = 0;

void write_number() {
    for (int i = 0; i < 1000; ++i) ++number;
}

}  // namespace

int main() {
    { const std::jthread first(write_number), second(write_number); }
    std::printf("nobody reported a race; the number is %d\n", number);
}
