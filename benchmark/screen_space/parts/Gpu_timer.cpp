#include "Gpu_timer.h"

#include "Table.h"

#include <support/gl_program.h>

#include <epoxy/gl.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <limits>
#include <vector>

namespace screen_space {

Frame_time time_of(const std::function<void()>& frame, double seconds)
{
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start)
  { return std::chrono::duration<double>(Clock::now() - start).count(); };
  GLuint query = 0;
  glGenQueries(1, &query);
  std::vector<double> gpu, wall, processor;
  const Clock::time_point start = Clock::now();
  for(int k = 0; k < 3 && (k == 0 || since(start) < .3 * seconds); ++k)
    frame();
  glFinish();
  // a frame of many seconds is as steady as it gets
  const std::size_t least = since(start) > 3. ? 1 : 3;
  const Clock::time_point first = Clock::now();
  while(gpu.size() < least || (gpu.size() < 200 && since(first) < seconds))
  {
    const Clock::time_point begin = Clock::now();
    const std::clock_t of_threads = std::clock();
    glBeginQuery(GL_TIME_ELAPSED, query);
    frame();
    glEndQuery(GL_TIME_ELAPSED);
    glFinish();
    wall.push_back(1e3 * since(begin));
    processor.push_back(1e3 * double(std::clock() - of_threads) / CLOCKS_PER_SEC);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    gpu.push_back(1e-6 * double(nanoseconds));
  }
  glDeleteQueries(1, &query);
  return {median(gpu), median(wall), median(processor), int(gpu.size())};
}

std::string renderer_name()
{
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

bool is_software_renderer()
{
  const std::string name = renderer_name();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SWR") != std::string::npos;
}

double measured_bandwidth()
{
  if(is_software_renderer())
    return std::numeric_limits<double>::quiet_NaN();
  constexpr char shader[] = R"(#version 430 core
layout(local_size_x = 32, local_size_y = 8) in;
uniform sampler2D from;
layout(rgba32f, binding = 0) writeonly uniform image2D to;
void main()
{
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  imageStore(to, p, texelFetch(from, p, 0));
}
)";
  constexpr int size = 8192;
  const unsigned program = support::gl_program({{GL_COMPUTE_SHADER, shader}});
  GLuint textures[2];
  glGenTextures(2, textures);
  for(const GLuint t : textures)
  {
    glBindTexture(GL_TEXTURE_2D, t);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, size, size);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const float one[4] = {1.f, 2.f, 3.f, 4.f};
    if(epoxy_gl_version() >= 44)
      glClearTexImage(t, 0, GL_RGBA, GL_FLOAT, one);
  }
  glBindTexture(GL_TEXTURE_2D, textures[0]);
  glBindSampler(0, 0);
  glUseProgram(program);
  glBindImageTexture(0, textures[1], 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  const Frame_time time = time_of(
      [&]
      {
        glDispatchCompute(GLuint(size / 32), GLuint(size / 8), 1);
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
      },
      1.);
  glUseProgram(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glDeleteTextures(2, textures);
  glDeleteProgram(program);
  return 32. * double(size) * double(size) / (1e6 * time.gpu);
}

} // namespace screen_space
