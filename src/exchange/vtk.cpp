#include "exchange/vtk.h"

#include <limits>

#include <fmt/format.h>

#include "exchange/bytes.h"

namespace lamella::exchange {

namespace {

// The header of a file with its arrays, which stand as raw bytes at its end.
class VtkFile {
 public:
  VtkFile(std::string_view type, std::string_view piece) {
    text_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<{0}>\n<Piece {1}>\n",
        type, piece);
    end_ = fmt::format("</Piece>\n</{}>\n", type);
  }

  void open(std::string_view group) { text_ += fmt::format("<{}>\n", group); }
  void close(std::string_view group) { text_ += fmt::format("</{}>\n", group); }

  template <class Number, class Values>
  void array(std::string_view type, std::string_view name, int width, const Values& values) {
    text_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type, name, width, data_.size());
    append<std::uint64_t>(data_, values.size() * sizeof(Number));
    data_.reserve(data_.size() + values.size() * sizeof(Number));
    for (const auto& value : values) append(data_, static_cast<Number>(value));
  }

  void attributes(const std::vector<Attribute>& list) {
    for (const Attribute& a : list) {
      if (a.whole) {
        array<std::int32_t>("Int32", a.name, a.width, a.values);
      } else {
        array<double>("Float64", a.name, a.width, a.values);
      }
    }
  }

  std::string finish() {
    return text_ + end_ + "<AppendedData encoding=\"raw\">\n_" + data_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string text_;
  std::string end_;
  std::string data_;
};

void points(VtkFile& file, const Mesh& mesh) {
  std::vector<double> places;
  places.reserve(3 * mesh.points.size());
  for (const film::Vec3& p : mesh.points) places.insert(places.end(), {p.x, p.y, p.z});
  file.open("Points");
  file.array<double>("Float64", "Points", 3, places);
  file.close("Points");
}

// Points of cells one after the other, and where each cell ends.
struct Cells {
  std::vector<std::int64_t> points;
  std::vector<std::int64_t> ends;

  template <class List>
  void add(const List& list) {
    points.insert(points.end(), list.begin(), list.end());
    ends.push_back(static_cast<std::int64_t>(points.size()));
  }
  void write(VtkFile& file) const {
    file.array<std::int64_t>("Int64", "connectivity", 1, points);
    file.array<std::int64_t>("Int64", "offsets", 1, ends);
  }
};

// Those of lines come first, then those of triangles.
void cell_data(VtkFile& file, const Mesh& mesh) {
  std::vector<double> kind;
  std::vector<double> front(mesh.lines.size(), -1);
  std::vector<double> behind = front;
  for (const Line& line : mesh.lines) {
    kind.push_back(line.kind == picture::LineKind::border ? 1 : line.kind == picture::LineKind::rim ? 2 : 3);
  }
  for (const film::RegionPair& pair : mesh.regions) {
    kind.push_back(0);
    front.push_back(pair.front.index);
    behind.push_back(pair.behind.index);
  }
  std::vector<Attribute> all = {
      {"kind", 1, true, kind}, {"front", 1, true, front}, {"behind", 1, true, behind}};
  for (Attribute a : mesh.of_triangles) {
    const double none = a.whole ? -1 : std::numeric_limits<double>::quiet_NaN();
    a.values.insert(a.values.begin(), mesh.lines.size() * static_cast<std::size_t>(a.width), none);
    all.push_back(std::move(a));
  }
  file.open("CellData");
  file.attributes(all);
  file.close("CellData");
}

void point_data(VtkFile& file, const Mesh& mesh) {
  file.open("PointData");
  file.attributes(mesh.of_points);
  file.close("PointData");
}

}  // namespace

std::string write_vtp(const Mesh& mesh) {
  VtkFile file("PolyData", fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
                                       "NumberOfStrips=\"0\" NumberOfPolys=\"{}\"",
                                       mesh.points.size(), mesh.lines.size(), mesh.triangles.size()));
  points(file, mesh);
  Cells lines;
  for (const Line& line : mesh.lines) lines.add(line.points);
  file.open("Lines");
  lines.write(file);
  file.close("Lines");
  Cells triangles;
  for (const Triple& t : mesh.triangles) triangles.add(t);
  file.open("Polys");
  triangles.write(file);
  file.close("Polys");
  point_data(file, mesh);
  cell_data(file, mesh);
  return file.finish();
}

std::string write_vtu(const Mesh& mesh) {
  constexpr int poly_line = 4;  // as VTK numbers types of cells
  constexpr int triangle = 5;
  VtkFile file("UnstructuredGrid",
               fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", mesh.points.size(),
                           mesh.lines.size() + mesh.triangles.size()));
  points(file, mesh);
  Cells cells;
  for (const Line& line : mesh.lines) cells.add(line.points);
  for (const Triple& t : mesh.triangles) cells.add(t);
  std::vector<int> types(mesh.lines.size(), poly_line);
  types.resize(mesh.lines.size() + mesh.triangles.size(), triangle);
  file.open("Cells");
  cells.write(file);
  file.array<std::uint8_t>("UInt8", "types", 1, types);
  file.close("Cells");
  point_data(file, mesh);
  cell_data(file, mesh);
  return file.finish();
}

std::string write_pvd(const std::vector<Moment>& moments) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const Moment& moment : moments)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", moment.time, moment.file);
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace lamella::exchange
