// Data sets 58 and 58b.
#include "io/universal/fields.hpp"
#include "io/universal/writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace plica {

using universal::Fields;

namespace {

using Eigen::Index;

void check(const UniversalFunction& f, const Fields& fields) {
  const auto agrees = [&](const Eigen::VectorXd& part, bool needed) {
    return part.size() == (needed ? f.real.size() : 0);
  };
  if (!agrees(f.abscissa, !f.even) || !agrees(f.imaginary, is_complex(f.data_type)))
    fields.fail("abscissa, real and imaginary parts are not of one length",
                "an abscissa when uneven, an imaginary part when complex, nothing else");
}

void write_axis(Fields& fields, int record, const UniversalAxis& axis) {
  fields.record(record).whole(axis.data_type, 10);
  fields.whole(axis.length, 5).whole(axis.force, 5).whole(axis.temperature, 5);
  fields.name("", 1).name(axis.label, 20).name("", 1).name(axis.unit, 20).end_line();
}

void write_dof(Fields& fields, const UniversalDof& dof) {
  fields.name("", 1).name(dof.entity, 10).whole(dof.node, 10).whole(dof.direction, 4);
}

void write_header(Fields& fields, const UniversalFunction& f) {
  for (std::size_t i = 0; i < f.ids.size(); ++i) fields.record(int(i) + 1).id(f.ids[i]);
  fields.record(6).whole(int(f.type), 5).whole(f.id, 10).whole(f.version, 5);
  fields.whole(f.load_case, 10);
  write_dof(fields, f.response);
  write_dof(fields, f.reference);
  fields.end_line();
  fields.record(7).whole(int(f.data_type), 10).whole(f.real.size(), 10).whole(f.even ? 1 : 0, 10);
  fields.abscissa(f.x0).abscissa(f.dx).abscissa(f.z).end_line();
  write_axis(fields, 8, f.abscissa_axis);
  write_axis(fields, 9, f.numerator);
  write_axis(fields, 10, f.denominator);
  write_axis(fields, 11, f.z_axis);
  fields.record(12);
}

// 6E13.5 single; 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12 double.
void write_ascii(Fields& fields, const UniversalFunction& f) {
  const bool wide = is_double(f.data_type), complex = is_complex(f.data_type);
  const int width = wide ? 20 : 13, decimals = wide ? 12 : 5;
  const int per_point = (f.even ? 0 : 1) + (complex ? 2 : 1);
  const Index numbers = !wide ? 6 : f.even || !complex ? 4 : 3, points = numbers / per_point;
  for (Index k = 0; k < f.real.size(); ++k) {
    if (!f.even) fields.abscissa(f.abscissa[k]);
    fields.real(f.real[k], width, decimals);
    if (complex) fields.real(f.imaginary[k], width, decimals);
    if ((k + 1) % points == 0 || k + 1 == f.real.size()) fields.end_line();
  }
}

template <class Float> void append(std::string& data, double value, UniversalByteOrder order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Float)>>(Float(value));
  if ((order == UniversalByteOrder::little_endian) != (std::endian::native == std::endian::little))
    std::reverse(bytes.begin(), bytes.end());
  data.append(bytes.data(), bytes.size());
}

std::string binary_data(const UniversalFunction& f, const Fields& fields) {
  std::string data;
  const auto put = [&](double value, bool wide) {
    if (!std::isfinite(value) || (!wide && std::abs(value) > std::numeric_limits<float>::max()))
      fields.fail("a number is NaN, infinite or beyond single precision", "finite numbers");
    if (wide)
      append<double>(data, value, f.binary->order);
    else
      append<float>(data, value, f.binary->order);
  };
  const bool wide = is_double(f.data_type);
  for (Index k = 0; k < f.real.size(); ++k) {
    if (!f.even) put(f.abscissa[k], f.binary->abscissa_bytes == 8);
    put(f.real[k], wide);
    if (is_complex(f.data_type)) put(f.imaginary[k], wide);
  }
  return data;
}

std::string binary_text(const UniversalFunction& f) {
  Fields check_fields("58b", "");
  check(f, check_fields);
  if (f.binary->format != UniversalFloatFormat::ieee)
    check_fields.fail("the floating point format is not IEEE", "UniversalFloatFormat::ieee");
  if (f.binary->abscissa_bytes != 4 && f.binary->abscissa_bytes != 8)
    check_fields.fail("the abscissa is neither single nor double", "4 or 8 bytes");
  const std::string data = binary_data(f, check_fields.record(12));
  const auto wide = [](auto value) {
    const std::string digits = std::to_string(value);
    return std::string(12 - std::min<std::size_t>(12, digits.size()), ' ') + digits;
  };
  Fields fields("58b", "    58b     " + std::to_string(int(f.binary->order)) + "     2" + wide(11) +
                           wide(data.size()) + "     0     0" + wide(0) + wide(0));
  write_header(fields, f);
  return fields.bytes(data).closed();
}

} // namespace

std::string universal_text(const UniversalFunction& f) {
  if (f.binary) return binary_text(f);
  Fields fields("58", "    58");
  check(f, fields);
  write_header(fields, f);
  write_ascii(fields, f);
  return fields.closed();
}

} // namespace plica
