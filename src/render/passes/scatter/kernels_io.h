// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_KERNELS_IO_H
#define DERMIS_PASSES_KERNELS_IO_H
// The kernels of convolutions, as kernels.h tabulates them.
#define KERNEL_RADIUS 12      // taps -12 .. 12
#define KERNEL_MAX_SIGMA 4.0  // in units of the tap spacing: three sigma on either side
#define SPACED_MAX_SIGMA 2.0  // the same, of light that is blurred already: taps may leave texels out
#define KERNEL_ROWS 257       // sigma = 0 .. KERNEL_MAX_SIGMA
#define KERNEL_FLOATS 16      // of a row, whole texels: weights of taps 0, +-1, .. +-12; the rest is 0
#endif
