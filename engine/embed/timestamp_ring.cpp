// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/timestamp_ring.hpp"

namespace polylume::embed {

TimestampRing::TimestampRing(const gl::Functions& gl) : gl_(gl) {
    // A driver without a clock has counters of 0 bits.
    GLint bits = 0;
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    hasTimestamps_ = bits > 0;
    if (hasTimestamps_) {
        gl.CreateQueries(GL_TIMESTAMP, static_cast<GLsizei>(names_.size()), names_.data());
    }
}

TimestampRing::~TimestampRing() {
    if (hasTimestamps_) gl_.DeleteQueries(static_cast<GLsizei>(names_.size()), names_.data());
}

void TimestampRing::begin() {
    if (!hasTimestamps_) return;
    collect();
    isOpen_ = begun_ - collected_ < kPairCount;
    if (isOpen_) gl_.QueryCounter(names_[2 * (begun_ % kPairCount)], GL_TIMESTAMP);
}

void TimestampRing::end() {
    if (!isOpen_) return;
    gl_.QueryCounter(names_[2 * (begun_ % kPairCount) + 1], GL_TIMESTAMP);
    ++begun_;
    isOpen_ = false;
}

std::optional<double> TimestampRing::latestSeconds() {
    if (hasTimestamps_) collect();
    return seconds_;
}

void TimestampRing::collect() {
    for (; collected_ < begun_; ++collected_) {
        const std::size_t first = 2 * (collected_ % kPairCount);
        GLint isAvailable = GL_FALSE;
        gl_.GetQueryObjectiv(names_[first + 1], GL_QUERY_RESULT_AVAILABLE, &isAvailable);
        if (isAvailable == GL_FALSE) return;
        GLuint64 from = 0, to = 0;
        gl_.GetQueryObjectui64v(names_[first], GL_QUERY_RESULT, &from);
        gl_.GetQueryObjectui64v(names_[first + 1], GL_QUERY_RESULT, &to);
        // Nanoseconds.
        seconds_ = to > from ? 1e-9 * static_cast<double>(to - from) : 0.0;
    }
}

}  // namespace polylume::embed
