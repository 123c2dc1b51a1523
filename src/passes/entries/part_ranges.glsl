// SPDX-License-Identifier: MIT
// The workgroup that ends last gives each part its range of the list of the band, in the order of the parts,
// and its indirect dispatch. Needs `io`, `parts`, `ranges`, and workgroups of 64.
shared uint sums[64];
shared bool is_last;

bool is_last_workgroup() {
  memoryBarrierBuffer();
  barrier();
  if (gl_LocalInvocationIndex == 0u)
    is_last =
        atomicAdd(parts[io.counter].count, 1u) == gl_NumWorkGroups.x * gl_NumWorkGroups.y - 1u;
  barrier();
  memoryBarrierBuffer();
  return is_last;
}

void give_ranges() {
  const uint each = (io.parts + 63u) / 64u, from = min(gl_LocalInvocationIndex * each, io.parts),
             to = min(from + each, io.parts);
  uint sum = 0u;
  for (uint i = from; i < to; ++i) sum += parts[io.first_part + i].count;
  sums[gl_LocalInvocationIndex] = sum;
  barrier();

  uint first = 2u * io.parts;  // words of the ranges themselves
  for (uint k = 0u; k < gl_LocalInvocationIndex; ++k) first += sums[k];
  for (uint i = from; i < to; ++i) {
    const uint part = io.first_part + i, count = parts[part].count,
               groups = (count + ENTRY_GROUP - 1u) / ENTRY_GROUP;
    ranges[i] = PartRangeIo(first, count);
    parts[part].groups[0] = min(groups, ENTRY_ROW);
    parts[part].groups[1] = (groups + ENTRY_ROW - 1u) / ENTRY_ROW;
    parts[part].groups[2] = 1u;
    first += count;
  }
}
