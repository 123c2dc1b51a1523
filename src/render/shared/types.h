// SPDX-License-Identifier: MIT
// Lets one header be read by C++ and by GLSL (scalar block layout: no padding, as glm lays out its vectors).
#ifndef DERMIS_SHARED_TYPES_H
#define DERMIS_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define DERMIS_IO_BEGIN       \
  namespace dermis::io {      \
  using uint = std::uint32_t; \
  using glm::vec2;            \
  using glm::vec3;            \
  using glm::vec4;            \
  using glm::uvec2;           \
  using glm::uvec4;           \
  using glm::ivec2;           \
  using glm::mat4;
#define DERMIS_IO_END }
#else
#extension GL_EXT_scalar_block_layout : require
#define DERMIS_IO_BEGIN
#define DERMIS_IO_END
#endif

#endif
