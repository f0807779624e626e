#include "xml.hpp"

#include <doctest/doctest.h>
#include <libxml/parser.h>
#include <libxml/xpath.h>
#include <libxml/xpathInternals.h>

namespace deixis::tests {

namespace {

const xmlChar* bytes(const char* text) {
    return reinterpret_cast<const xmlChar*>(text);
}

std::string taken(xmlChar* text) {
    std::string out = text == nullptr ? "" : reinterpret_cast<const char*>(text);
    xmlFree(text);
    return out;
}

struct FreeResult {
    void operator()(xmlXPathObject* result) const { xmlXPathFreeObject(result); }
};
using Found = std::unique_ptr<xmlXPathObject, FreeResult>;

}  // namespace

struct XmlDocument::Parsed {
    xmlDoc* document = nullptr;
    xmlXPathContext* context = nullptr;

    [[nodiscard]] Found find(const std::string& path) const {
        Found found(xmlXPathEvalExpression(bytes(path.c_str()), context));
        REQUIRE_MESSAGE(found != nullptr, path);
        REQUIRE_MESSAGE(found->type == XPATH_NODESET, path);
        return found;
    }
};

XmlDocument::XmlDocument(const std::string& text) : parsed_(std::make_unique<Parsed>()) {
    parsed_->document = xmlReadMemory(text.data(), static_cast<int>(text.size()), "page", nullptr,
                                      XML_PARSE_NONET | XML_PARSE_HUGE);
    REQUIRE(parsed_->document != nullptr);
    parsed_->context = xmlXPathNewContext(parsed_->document);
    REQUIRE(parsed_->context != nullptr);
    xmlXPathRegisterNs(parsed_->context, bytes("h"), bytes("http://www.w3.org/1999/xhtml"));
    xmlXPathRegisterNs(parsed_->context, bytes("s"), bytes("http://www.w3.org/2000/svg"));
}

XmlDocument::~XmlDocument() {
    xmlXPathFreeContext(parsed_->context);
    xmlFreeDoc(parsed_->document);
}

int XmlDocument::count(const std::string& path) const {
    const Found found = parsed_->find(path);
    return found->nodesetval == nullptr ? 0 : found->nodesetval->nodeNr;
}

std::vector<std::string> XmlDocument::texts(const std::string& path) const {
    const Found found = parsed_->find(path);
    std::vector<std::string> out;
    for (int i = 0; found->nodesetval != nullptr && i < found->nodesetval->nodeNr; ++i)
        out.push_back(taken(xmlNodeGetContent(found->nodesetval->nodeTab[i])));
    return out;
}

std::map<std::string, std::string> XmlDocument::row(const std::string& path) const {
    REQUIRE_MESSAGE(count(path) == 1, path);
    const auto heads = texts(path + "/ancestor::h:table/h:thead/h:tr/h:th");
    const auto cells = texts(path + "/*");
    REQUIRE(heads.size() == cells.size());
    std::map<std::string, std::string> out;
    for (std::size_t i = 0; i < heads.size(); ++i) out[heads[i]] = cells[i];
    return out;
}

std::string XmlDocument::text() const {
    return taken(xmlNodeGetContent(xmlDocGetRootElement(parsed_->document)));
}

}  // namespace deixis::tests
