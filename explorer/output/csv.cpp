#include "output/csv.h"

#include <cmath>
#include <ostream>

#include "delos/text/number_text.h"

namespace delos {

void write_csv(const Field& field, std::ostream& out) {
  out << "x,y,z,value,observable\n";
  std::string line;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    line.clear();
    for (const double coordinate : field.samples.points[i]) {
      append_number(line, coordinate);
      line += ',';
    }
    if (std::isfinite(field.value[i])) append_number(line, field.value[i]);
    line += field.observable[i] != 0 ? ",1\n" : ",0\n";
    out << line;
  }
}

}  // namespace delos
