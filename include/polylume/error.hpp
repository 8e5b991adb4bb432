// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <stdexcept>

#include "polylume/api.h"

namespace polylume {

/// What Polylume throws for bad input, a missing file or a failing driver. The message says what
/// was expected, what was found, where, and what to do next.
class POLYLUME_API Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// No OpenGL context could be created.
class POLYLUME_API ContextError : public Error {
  public:
    using Error::Error;
};

/// A shader could not be assembled, compiled or linked.
class POLYLUME_API ShaderError : public Error {
  public:
    using Error::Error;
};

}  // namespace polylume
