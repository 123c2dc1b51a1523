// SPDX-License-Identifier: MIT
// The id of the triangle, as four bytes.
#version 460
layout(location = 0) flat in uint in_id;
layout(location = 0) out vec4 out_id;
void main() { out_id = unpackUnorm4x8(in_id); }
