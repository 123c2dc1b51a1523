// SPDX-License-Identifier: MIT
// What is fuzzed: one function per reader. Each takes a file's bytes and returns whether the reader accepted
// them. A refusal must be an InputError of one line. Everything else is a finding: another exception, a
// crash, a result that breaks the reader's contract, more time or memory than the fuzzer grants.
#pragma once

#include <cstddef>
#include <span>

namespace dermis::fuzz {

using Bytes = std::span<const std::byte>;

bool gltf(Bytes file);  ///< .gltf or .glb, as load_gltf() and the preparation of the skin take it
bool glb(
    Bytes json_and_bin);  ///< the JSON text, a zero byte, the binary chunk: lengths and padding are right
bool png(Bytes file);     ///< the checksum of each chunk is made right first
bool jpeg(Bytes file);
bool hdr(Bytes file);
bool exr(Bytes file);
bool scene_file(Bytes json);  ///< a scene, without its assets
bool profile(Bytes json);     ///< a sum of Gaussians
bool layers(Bytes json);      ///< layers of tissue
bool table(Bytes csv);        ///< R(r) as numbers
bool exchange(Bytes text);    ///< parameters of another engine
bool benchmark(Bytes json);   ///< a record of `dermis bench --json`
/// One byte that chooses (even: a whole file; odd: what follows its header, behind a right checksum), then
/// the bytes.
bool checkpoint(Bytes choice_and_bytes);
/// The same choice.
bool occlusion_cache(Bytes choice_and_bytes);
bool monte_carlo_cache(Bytes lines);  ///< the lines between key and checksum, which are made right

}  // namespace dermis::fuzz
