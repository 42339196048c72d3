#include "Ply_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace support {

namespace {

void append_bytes(std::string& out, std::uint64_t bits, int count)
{
  for(int i = 0; i < count; ++i)
    out += char(bits >> (8 * i) & 0xff);
}

void append(std::string& out, double value, bool ascii)
{
  if(ascii)
  {
    char text[40];
    if(std::isnan(value)) // not "-nan"
      std::snprintf(text, sizeof text, "nan ");
    else
      std::snprintf(text, sizeof text, "%.17g ", value);
    out += text;
    return;
  }
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  append_bytes(out, bits, 8);
}

} // namespace

Ply_file::Ply_file(std::vector<Vector> points) : points_(std::move(points)) {}

void Ply_file::set_triangles(std::vector<std::array<std::size_t, 3>> triangles)
{
  std::vector<std::vector<std::size_t>> faces;
  faces.reserve(triangles.size());
  for(const auto& t : triangles)
    faces.emplace_back(t.begin(), t.end());
  set_faces(std::move(faces));
}

void Ply_file::set_faces(std::vector<std::vector<std::size_t>> faces)
{
  if(points_.size() > 0x7fffffff)
    throw std::invalid_argument("Ply_file: faces: more vertices than their indices can number");
  for(const auto& face : faces)
  {
    if(face.size() < 3 || face.size() > 255)
      throw std::invalid_argument("Ply_file: faces: a face must have 3 to 255 vertices");
    for(std::size_t v : face)
      if(v >= points_.size())
        throw std::invalid_argument("Ply_file: faces: vertex " + std::to_string(v) + " does not exist");
  }
  faces_ = std::move(faces);
  has_faces_ = true;
}

void Ply_file::add(Property property)
{
  if(std::max(property.doubles.size(), property.uchars.size()) != points_.size())
    throw std::invalid_argument("Ply_file: '" + property.name + "' must have one value per point");
  const auto allowed = [](char c)
  { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  if(property.name.empty() || !std::all_of(property.name.begin(), property.name.end(), allowed))
    throw std::invalid_argument("Ply_file: '" + property.name + "' is no name for a property");
  const auto taken = [&](const Property& p) { return p.name == property.name; };
  if(property.name == "x" || property.name == "y" || property.name == "z" ||
     std::any_of(properties_.begin(), properties_.end(), taken))
    throw std::invalid_argument("Ply_file: there is a property '" + property.name + "' already");
  properties_.push_back(std::move(property));
}

void Ply_file::add_scalar(const std::string& name, std::vector<double> values)
{
  add({name, std::move(values), {}});
}

void Ply_file::add_vector(const std::string& name, const std::vector<Vector>& values)
{
  for(std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double> component;
    component.reserve(values.size());
    for(const Vector& v : values)
      component.push_back(v[c]);
    const std::string separator = name == "n" ? "" : "_";
    add({name + separator + "xyz" [c], std::move(component), {}});
  }
}

void Ply_file::add_uchar(const std::string& name, std::vector<std::uint8_t> values)
{
  add({name, {}, std::move(values)});
}

void Ply_file::add_normals(const std::vector<Vector>& normals)
{
  add_vector("n", normals);
}

void Ply_file::add_colors(const std::vector<Rgba>& colors)
{
  std::vector<std::uint8_t> red, green, blue;
  for(Rgba c : colors)
  {
    red.push_back(c.r);
    green.push_back(c.g);
    blue.push_back(c.b);
  }
  add_uchar("red", std::move(red));
  add_uchar("green", std::move(green));
  add_uchar("blue", std::move(blue));
}

void Ply_file::add_comment(const std::string& text)
{
  if(text.find_first_of("\n\r") != std::string::npos)
    throw std::invalid_argument("Ply_file: a comment is one line");
  comments_.push_back(text);
}

void Ply_file::write(const std::string& file_name, Ply_format format) const
{
  const bool ascii = format == Ply_format::ASCII;
  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
  for(const std::string& comment : comments_)
    out += "comment " + comment + "\n";
  out += "element vertex " + std::to_string(points_.size()) + "\n";
  out += "property double x\nproperty double y\nproperty double z\n";
  for(const Property& p : properties_)
    out += std::string("property ") + (p.uchars.empty() ? "double " : "uchar ") + p.name + "\n";
  if(has_faces_)
    out += "element face " + std::to_string(faces_.size()) + "\nproperty list uchar int vertex_indices\n";
  out += "end_header\n";

  std::ofstream file(file_name, std::ios::binary);
  const auto flush = [&]
  {
    file.write(out.data(), std::streamsize(out.size()));
    out.clear();
  };
  for(std::size_t i = 0; i < points_.size(); ++i)
  {
    for(double coordinate : points_[i])
      append(out, coordinate, ascii);
    for(const Property& p : properties_)
      if(p.uchars.empty())
        append(out, p.doubles[i], ascii);
      else if(ascii)
        out += std::to_string(p.uchars[i]) + ' ';
      else
        out += char(p.uchars[i]);
    if(ascii)
      out.back() = '\n';
    if(out.size() > 1 << 20)
      flush();
  }
  for(const auto& face : faces_)
  {
    if(ascii)
      out += std::to_string(face.size());
    else
      out += char(face.size());
    for(std::size_t v : face)
      if(ascii)
        out += ' ' + std::to_string(v);
      else
        append_bytes(out, v, 4);
    if(ascii)
      out += '\n';
    if(out.size() > 1 << 20)
      flush();
  }
  flush();
  file.close();
  if(!file)
    throw std::runtime_error("Ply_file: cannot write '" + file_name + "'");
}

} // namespace support
