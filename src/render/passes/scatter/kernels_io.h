// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_KERNELS_IO_H
#define DERMIS_PASSES_KERNELS_IO_H
// The kernels of convolutions, as kernels.h tabulates them.
#define KERNEL_RADIUS 6       // taps -6 .. 6
#define KERNEL_MAX_SIGMA 2.0  // in units of the tap spacing: three sigma on either side
#define KERNEL_ROWS 129       // sigma = 0 .. KERNEL_MAX_SIGMA
#define KERNEL_FLOATS 8       // of a row, whole texels: weights of taps 0, +-1, .. +-6, and its variance
#endif
