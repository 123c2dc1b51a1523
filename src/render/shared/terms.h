// SPDX-License-Identifier: MIT
#ifndef DERMIS_SHARED_TERMS_H
#define DERMIS_SHARED_TERMS_H
#define MOST_TERMS 8  // Gaussians of a profile
#endif
