# cmake -DFROM=references.bib -DTO=references.cpp -P embed_references.cmake: the bibliography as a string literal.
file(READ ${FROM} text)
file(WRITE ${TO} "#include \"suffuse/report/references.hpp\"

namespace suffuse::report {

std::string_view bibliography() {
    return R\"bib(
${text})bib\";
}

} // namespace suffuse::report
")
