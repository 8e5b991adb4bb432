// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/pass_clock.hpp"

#include <algorithm>

namespace polylume {

PassClock::Scope::Scope(PassClock* clock, const char* pass) : clock_(clock) {
    if (clock_ != nullptr) clock_->begin(pass);
}

PassClock::Scope::~Scope() {
    if (clock_ != nullptr) clock_->end();
}

PassClock::~PassClock() {
    for (auto& [pass, ring] : rings_) {
        gl_.DeleteQueries(static_cast<GLsizei>(ring.queries.size()), ring.queries.data());
    }
}

void PassClock::begin(const char* pass) {
    const auto [entry, isNew] = rings_.try_emplace(pass);
    Ring& ring = entry->second;
    if (isNew) {
        ring.place = times_.size();
        times_.push_back({pass});
        gl_.CreateQueries(GL_TIME_ELAPSED, static_cast<GLsizei>(ring.queries.size()),
                          ring.queries.data());
    }
    if (ring.pending[ring.next] && !takeResult(ring, ring.next)) return;
    gl_.BeginQuery(GL_TIME_ELAPSED, ring.queries[ring.next]);
    ring.pending[ring.next] = true;
    ring.next = (ring.next + 1) % Ring::kLength;
    isTiming_ = true;
}

void PassClock::end() {
    if (isTiming_) gl_.EndQuery(GL_TIME_ELAPSED);
    isTiming_ = false;
}

bool PassClock::takeResult(Ring& ring, std::size_t index) {
    GLuint available = GL_FALSE;
    gl_.GetQueryObjectuiv(ring.queries[index], GL_QUERY_RESULT_AVAILABLE, &available);
    if (available == GL_FALSE) return false;
    GLuint64 nanoseconds = 0;
    gl_.GetQueryObjectui64v(ring.queries[index], GL_QUERY_RESULT, &nanoseconds);
    times_[ring.place].milliseconds = 1e-6 * static_cast<double>(nanoseconds);
    ring.pending[index] = false;
    return true;
}

const std::vector<PassClock::Time>& PassClock::collect() {
    for (auto& [pass, ring] : rings_) {
        // From the oldest on.
        for (std::size_t i = 0; i < Ring::kLength; ++i) {
            const std::size_t index = (ring.next + i) % Ring::kLength;
            if (ring.pending[index]) takeResult(ring, index);
        }
    }
    return times_;
}

double PassClock::milliseconds(const std::string& pass) const {
    const auto found = std::ranges::find(times_, pass, &Time::pass);
    return found == times_.end() ? 0.0 : found->milliseconds;
}

}  // namespace polylume
