// The shaders are installed with the headers, and there is an error, not an end of the program, where there is no OpenGL.
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>

#include <iostream>
#include <stdexcept>

int main()
try
{
  Shape_characteristics::Screen_space_curvature_pass curvature;
  Shape_characteristics::Sphere_fit_mean_curvature_pass spheres;
  return 1;
}
catch(const std::runtime_error& e)
{
  std::cout << e.what() << '\n';
}
