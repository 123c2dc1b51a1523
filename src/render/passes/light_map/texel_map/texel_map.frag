// SPDX-License-Identifier: MIT
#version 460
layout(location = 0) flat in uint in_number;
layout(location = 0) out uint out_number;
void main() { out_number = in_number; }
