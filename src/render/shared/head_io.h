// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_HEAD_IO_H
#define DERMIS_SHARED_HEAD_IO_H
#include "render/shared/instance_io.h"
#include "render/shared/scene_io.h"
DERMIS_IO_BEGIN
// Data that differ from head to head, in one buffer: devices may have no more than 32 bindings.
struct HeadIo {
  InstanceIo instance;
  LampsIo lamps;
};
DERMIS_IO_END
#endif
