// SPDX-License-Identifier: MIT
// A row of the table of kernels: weights of taps 0, +-1, .. Needs `Kernels`, that table as
// texels.
#extension GL_EXT_samplerless_texture_functions : require
#include "render/passes/scatter/kernels_io.h"

float kernel_row[KERNEL_FLOATS];

// Takes it from between two rows; rows are so dense that the variance is exact to 1e-4.
// row: 0 .. KERNEL_ROWS - 1, from first_row on. reach: of the taps that are wanted.
void load_kernel_row(float row, int first_row, int reach) {
  const int whole = min(int(row), KERNEL_ROWS - 2), texel = (first_row + whole) * (KERNEL_FLOATS / 4);
  for (int i = 0; i <= reach / 4; ++i) {
    const vec4 low = uintBitsToFloat(texelFetch(Kernels, texel + i)),
               high = uintBitsToFloat(texelFetch(Kernels, texel + KERNEL_FLOATS / 4 + i));
    const vec4 part = mix(low, high, row - float(whole));
    for (int k = 0; k < 4; ++k) kernel_row[4 * i + k] = part[k];
  }
}
