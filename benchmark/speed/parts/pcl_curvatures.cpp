// In a file of its own: PCL's headers are slow to compile.
#include "pcl_curvatures.h"

#ifdef SHAPE_CHARACTERISTICS_BENCHMARK_PCL

#include <pcl/features/principal_curvatures.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <memory>

namespace speed {

std::function<void()> pcl_principal_curvatures(const Workload& w, unsigned int neighbours)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  for(const Vertex v : w.vertices)
  {
    const Kernel::Point_3& p = w.mesh.point(v);
    const Kernel::Vector_3& n = w.normals[v];
    points->push_back(pcl::PointXYZ(float(p.x()), float(p.y()), float(p.z())));
    normals->push_back(pcl::Normal(float(n.x()), float(n.y()), float(n.z())));
  }
  return [points, normals, neighbours]
  {
    pcl::PrincipalCurvaturesEstimation<pcl::PointXYZ, pcl::Normal, pcl::PrincipalCurvatures> estimation;
    estimation.setInputCloud(points);
    estimation.setInputNormals(normals);
    estimation.setSearchMethod(
        pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
    estimation.setKSearch(int(neighbours));
    pcl::PointCloud<pcl::PrincipalCurvatures> result;
    estimation.compute(result);
  };
}

} // namespace speed

#else

namespace speed {

std::function<void()> pcl_principal_curvatures(const Workload&, unsigned int)
{
  return {};
}

} // namespace speed

#endif
