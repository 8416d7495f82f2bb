# cmake -DFROM=page/src/assess -DTO=assess_page.cpp -P embed_assess.cmake: the page of `suffuse assess --page` with its style
# and script inside, as a string literal.
file(READ ${FROM}/page.html page)
file(READ ${FROM}/page.css style)
file(READ ${FROM}/criteria.js criteria)
file(READ ${FROM}/atlas.js atlas)
file(READ ${FROM}/curve.js curve)
file(READ ${FROM}/page.js script)
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${criteria}\n${atlas}\n${curve}\n${script}" page "${page}")
file(WRITE ${TO} "#include \"suffuse/report/assess_page.hpp\"

namespace suffuse::report {

std::string_view assess_template() {
    return R\"page(
${page})page\";
}

} // namespace suffuse::report
")
