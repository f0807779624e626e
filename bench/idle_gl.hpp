// A GL that does nothing, to time what a program does on its own side of it.
#pragma once

#include <epoxy/gl.h>

#include <tuple>

namespace deixis::bench {

/// What Renderer::drawStereo() calls in a frame that is like the one before it; a call that is missing here
/// goes to the driver and would show as time.
inline auto frameCalls() {
    return std::tie(
        epoxy_glBindBufferBase, epoxy_glBindBufferRange, epoxy_glBindFramebuffer, epoxy_glBindSampler,
        epoxy_glBindTextureUnit, epoxy_glBindVertexArray, epoxy_glBlendFunc, epoxy_glBlitNamedFramebuffer,
        epoxy_glClearNamedFramebufferfv, epoxy_glColorMask, epoxy_glCullFace, epoxy_glDepthFunc,
        epoxy_glDepthMask, epoxy_glDisable, epoxy_glDispatchCompute, epoxy_glDrawArrays, epoxy_glDrawElements,
        epoxy_glDrawElementsInstanced, epoxy_glEnable, epoxy_glGetError, epoxy_glMemoryBarrier,
        epoxy_glNamedBufferSubData, epoxy_glNamedFramebufferTexture, epoxy_glNamedFramebufferTextureLayer,
        epoxy_glPolygonMode, epoxy_glUniform1ui, epoxy_glUniform3fv, epoxy_glUniform4f,
        epoxy_glUniformMatrix4fv, epoxy_glUseProgram, epoxy_glViewport);
}

/// While it lives, those calls only count themselves and return 0. Made after a first frame: compiling
/// shaders and making textures needs a GL that answers.
class IdleGl {
  public:
    IdleGl() {
        std::apply([](auto&... call) { (silence(call), ...); }, frameCalls());
    }
    ~IdleGl() { frameCalls() = real_; }
    IdleGl(const IdleGl&) = delete;
    IdleGl& operator=(const IdleGl&) = delete;
    [[nodiscard]] static long calls() { return calls_; }

  private:
    template <typename Result, typename... Arguments>
    static void silence(Result(GLAPIENTRY*& call)(Arguments...)) {
        call = [](Arguments...) -> Result {
            ++calls_;
            return Result();
        };
    }
    template <typename... Calls>
    static std::tuple<Calls...> copied(const std::tuple<Calls&...>& calls) {
        return calls;
    }

    inline static long calls_ = 0;
    decltype(copied(frameCalls())) real_ = copied(frameCalls());
};

}  // namespace deixis::bench
