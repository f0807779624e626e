#include "core/csv.hpp"

#include <fmt/format.h>

#include <utility>

namespace deixis {

namespace {

class CsvParser {
  public:
    CsvParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Result<std::vector<CsvRecord>> parse() {
        std::vector<CsvRecord> records;
        while (at_ < text_.size()) {
            if (atLineEnd()) {
                skipLineEnd();
                continue;
            }
            CsvRecord record;
            record.line = line_;
            for (;;) {
                auto field = readField();
                if (!field) return tl::unexpected(field.error());
                record.fields.push_back(std::move(*field));
                if (at_ >= text_.size() || text_[at_] != ',') break;
                ++at_;
            }
            skipLineEnd();
            records.push_back(std::move(record));
        }
        return records;
    }

  private:
    [[nodiscard]] bool atLineEnd() const {
        return text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_, 2) == "\r\n");
    }
    void skipLineEnd() {
        if (at_ >= text_.size()) return;
        at_ += text_[at_] == '\r' ? 2 : 1;
        ++line_;
    }

    Result<std::string> readField() {
        if (at_ < text_.size() && text_[at_] == '"') return readQuoted();
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != ',' && !atLineEnd()) {
            if (text_[at_] == '"')
                return fail(fmt::format("{}:{}", name_, line_), "a quote stands inside an unquoted field",
                            "Quote the whole field and double the quote");
            ++at_;
        }
        return std::string(text_.substr(begin, at_ - begin));
    }

    Result<std::string> readQuoted() {
        const int opened = line_;
        std::string out;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '"') {
                if (text_.substr(at_, 2) != "\"\"") break;
                ++at_;
            } else if (text_[at_] == '\n') {
                ++line_;
            }
            out += text_[at_];
        }
        if (at_ >= text_.size())
            return fail(fmt::format("{}:{}", name_, opened), "a quoted field has no closing quote");
        ++at_;
        if (at_ < text_.size() && text_[at_] != ',' && !atLineEnd())
            return fail(fmt::format("{}:{}", name_, line_),
                        "text follows a closing quote; expected a comma or the end of the line");
        return out;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

Result<std::vector<CsvRecord>> parseCsv(std::string_view text, const std::string& name) {
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    if (text.substr(0, utf8_mark.size()) == utf8_mark) text.remove_prefix(utf8_mark.size());
    return CsvParser(text, name).parse();
}

std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

}  // namespace deixis
