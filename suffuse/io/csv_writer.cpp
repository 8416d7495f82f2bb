#include "suffuse/io/csv_writer.hpp"

#include "suffuse/base/error.hpp"

#include <algorithm>

namespace suffuse::io {

CsvWriter::CsvWriter(const std::filesystem::path& path, std::string_view header)
    : file_(path), columns_(static_cast<std::size_t>(std::ranges::count(header, ',')) + 1) {
    file_.write(header);
    file_.write("\n");
}

void CsvWriter::end_row() {
    expects(fields_ == columns_, "a row has as many fields as the header of its table");
    line_.push_back('\n');
    file_.write({line_.data(), line_.size()});
}

void CsvWriter::finish() {
    file_.commit();
}

} // namespace suffuse::io
