/* Built for any x86-64, run before the C++ constructors: the rest of the program needs AVX2, FMA and BMI2. */
#include <unistd.h>

__attribute__((constructor(101))) static void require_cpu(void) {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) return;
    static const char sentence[] =
        "brewster: this processor lacks AVX2, FMA or BMI2, which the program is built for; run it on an x86-64 "
        "processor of 2013 (Haswell) or later\n";
    if (write(2, sentence, sizeof sentence - 1) < 0) _exit(1);
    _exit(1);
}
