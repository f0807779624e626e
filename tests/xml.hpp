// Pages and pictures by their structure: well-formed XML, asked by XPath.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace deixis::tests {

/// Names of XHTML have the prefix "h", those of SVG "s".
class XmlDocument {
  public:
    /// Fails the test where the text is no well-formed XML.
    explicit XmlDocument(const std::string& text);
    ~XmlDocument();
    XmlDocument(const XmlDocument&) = delete;
    XmlDocument& operator=(const XmlDocument&) = delete;

    /// How many nodes a path finds.
    [[nodiscard]] int count(const std::string& path) const;
    /// The texts of all nodes that a path finds, in the order of the document.
    [[nodiscard]] std::vector<std::string> texts(const std::string& path) const;
    /// The cells of the one row of a page's table that a path finds, by the heads of their columns.
    [[nodiscard]] std::map<std::string, std::string> row(const std::string& path) const;
    /// All that is written.
    [[nodiscard]] std::string text() const;

  private:
    struct Parsed;
    std::unique_ptr<Parsed> parsed_;
};

}  // namespace deixis::tests
