#pragma once
// One source of a loop, compiled for three generations of processors and chosen when the program starts. Contraction to
// fused operations is off, so all of them give the same bits.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define SUFFUSE_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SUFFUSE_CLONES
#endif
