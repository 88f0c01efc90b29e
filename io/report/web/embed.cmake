# Writes SCRIPT and STYLE as texts of a C++ source.
file(READ ${SCRIPT} script)
file(READ ${STYLE} style)
set(mark plica_text)
file(WRITE ${OUT} "#include \"io/report/scripts.hpp\"
namespace plica {
const std::string_view report_script = R\"${mark}(${script})${mark}\";
const std::string_view report_script_style = R\"${mark}(${style})${mark}\";
} // namespace plica
")
