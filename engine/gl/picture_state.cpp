// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/picture_state.hpp"

namespace polylume::gl {

void setPictureState(const Functions& gl) {
    for (const GLenum capability : kPictureCapabilities) gl.Disable(capability);
    gl.Disablei(GL_BLEND, 0);
    gl.Disablei(GL_SCISSOR_TEST, 0);
    gl.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace polylume::gl
