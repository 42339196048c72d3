#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <iostream>

double curvature_of_a_ball(double radius);

int main()
{
#ifdef CGAL_LINKED_WITH_TBB
  std::cout << "parallel: ";
#else
  std::cout << "sequential: ";
#endif
  const double curvature = curvature_of_a_ball(2);
  std::cout << "the mean curvature of a ball of radius 2 is " << curvature << "\n";
  return curvature > 0.499 && curvature < 0.501 ? 0 : 1;
}
