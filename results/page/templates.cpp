#include "results/page/templates.hpp"

#include <kainjow/mustache.hpp>
#include <stdexcept>

#define DEIXIS_TEMPLATE(name, file)            \
    __asm__(                                   \
        ".pushsection .rodata\n"               \
        ".global deixis_template_" #name       \
        "\n"                                   \
        "deixis_template_" #name               \
        ":\n"                                  \
        ".incbin \"" DEIXIS_TEMPLATES "/" file \
        "\"\n"                                 \
        ".byte 0\n"                            \
        ".popsection\n");                      \
    extern "C" const char deixis_template_##name[]

DEIXIS_TEMPLATE(claims, "claims.mustache");
DEIXIS_TEMPLATE(contents, "contents.mustache");
DEIXIS_TEMPLATE(evaluation_methods, "evaluation_methods.mustache");
DEIXIS_TEMPLATE(facts, "facts.mustache");
DEIXIS_TEMPLATE(figure, "figure.mustache");
DEIXIS_TEMPLATE(figures, "figures.mustache");
DEIXIS_TEMPLATE(folded, "folded.mustache");
DEIXIS_TEMPLATE(link, "link.mustache");
DEIXIS_TEMPLATE(list, "list.mustache");
DEIXIS_TEMPLATE(paragraph, "paragraph.mustache");
DEIXIS_TEMPLATE(css, "page.css");
DEIXIS_TEMPLATE(page_end, "page_end.mustache");
DEIXIS_TEMPLATE(page_start, "page_start.mustache");
DEIXIS_TEMPLATE(picture, "picture.mustache");
DEIXIS_TEMPLATE(report_methods, "report_methods.mustache");
DEIXIS_TEMPLATE(section, "section.mustache");
DEIXIS_TEMPLATE(strong, "strong.mustache");
DEIXIS_TEMPLATE(table, "table.mustache");

namespace deixis::results {

namespace {

using Data = kainjow::mustache::data;

constexpr std::pair<std::string_view, const char*> texts[]{
    {"claims.mustache", deixis_template_claims},
    {"contents.mustache", deixis_template_contents},
    {"evaluation_methods.mustache", deixis_template_evaluation_methods},
    {"facts.mustache", deixis_template_facts},
    {"figure.mustache", deixis_template_figure},
    {"figures.mustache", deixis_template_figures},
    {"folded.mustache", deixis_template_folded},
    {"link.mustache", deixis_template_link},
    {"list.mustache", deixis_template_list},
    {"page.css", deixis_template_css},
    {"page_end.mustache", deixis_template_page_end},
    {"page_start.mustache", deixis_template_page_start},
    {"paragraph.mustache", deixis_template_paragraph},
    {"picture.mustache", deixis_template_picture},
    {"report_methods.mustache", deixis_template_report_methods},
    {"section.mustache", deixis_template_section},
    {"strong.mustache", deixis_template_strong},
    {"table.mustache", deixis_template_table}};

Data dataOf(const Json& value) {
    if (value.is_boolean()) return {value.get<bool>() ? Data::type::bool_true : Data::type::bool_false};
    if (value.is_array()) {
        Data out(Data::type::list);
        for (const Json& one : value) out << dataOf(one);
        return out;
    }
    if (value.is_object()) {
        Data out(Data::type::object);
        for (const auto& [name, inner] : value.items())
            if (!inner.is_null() && !(inner.is_string() && inner.get_ref<const std::string&>().empty()))
                out.set(name, dataOf(inner));
        return out;
    }
    return {value.is_string() ? value.get<std::string>() : value.dump()};
}

}  // namespace

std::string templateText(std::string_view file) {
    for (const auto& [name, text] : texts)
        if (name == file) return text;
    throw std::logic_error("there is no template " + std::string(file));
}

std::string filled(std::string_view file, const Json& values) {
    kainjow::mustache::mustache skeleton(templateText(file));
    skeleton.set_custom_escape([](const std::string& plain) { return escapeHtml(plain); });
    return skeleton.render(dataOf(values));
}

std::string escapeHtml(std::string_view text) {
    std::string allowed;
    for (const char c : text)  // control characters are not allowed in XML
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') allowed += c;
    return kainjow::mustache::html_escape(allowed);
}

std::string strongHtml(const std::string& text) {
    return filled("strong.mustache", {{"text", text}});
}

}  // namespace deixis::results
