# cmake -DFROM=style.css -DTO=style.cpp -P embed_style.cmake: the style sheet as a string literal.
file(READ ${FROM} text)
file(WRITE ${TO} "#include \"suffuse/report/style.hpp\"

namespace suffuse::report {

std::string_view page_style() {
    return R\"css(
${text})css\";
}

} // namespace suffuse::report
")
