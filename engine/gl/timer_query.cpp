// SPDX-License-Identifier: MIT
#include "gl/timer_query.h"

#include <epoxy/gl.h>

namespace patina::gl {

TimerQuery TimerQuery::make(std::string_view label) {
    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_TIME_ELAPSED, name);  // brings it into being, so that it can be labelled
    glEndQuery(GL_TIME_ELAPSED);
    TimerQuery query;
    query.object_ = Object(ObjectKind::Query, name, label);
    return query;
}

void TimerQuery::begin() {
    glBeginQuery(GL_TIME_ELAPSED, object_.name());
}

void TimerQuery::end() {
    glEndQuery(GL_TIME_ELAPSED);
    ended_ = true;
}

std::optional<double> TimerQuery::elapsed_ms() const {
    if (!ended_) return std::nullopt;
    GLint available = GL_FALSE;
    glGetQueryObjectiv(object_.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    if (available != GL_TRUE) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(object_.name(), GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace patina::gl
