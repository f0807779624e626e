#include "core/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"

namespace deixis {

namespace {

/// Whether a spreadsheet may take it for a formula.
bool looksLikeFormula(std::string_view text) {
    if (text.empty()) return false;
    const char c = text.front();
    return c == '=' || c == '+' || c == '-' || c == '@' || c == '\t' || c == '\r';
}

}  // namespace

const char* separatorName(char separator) {
    return separator == ','   ? "a comma"
           : separator == ';' ? "a semicolon"
           : separator == ' ' ? "blanks"
                              : "a tab";
}

bool isCsvComment(std::string_view line) {
    return line.starts_with('#') || line.starts_with("sep=");
}

CsvReader::CsvReader(std::string_view text, std::string name, CsvForm form)
    : text_(withoutByteOrderMark(text)), name_(std::move(name)), form_(form) {}

Result<void> CsvReader::checkText() const {
    const auto bad = firstUnstorable(text_);
    if (!bad) return {};
    const auto before = text_.substr(0, *bad);
    return fail(fmt::format("{}:{}", name_, line_ + std::count(before.begin(), before.end(), '\n')),
                fmt::format("found the byte {:#04x}, which is not UTF-8 text",
                            static_cast<unsigned char>(text_[*bad])),
                "Save the file as CSV in UTF-8");
}

Result<bool> CsvReader::next(CsvRecord& record) {
    if (!std::exchange(checked_, true)) {
        if (auto text = checkText(); !text) return tl::unexpected(text.error());
        if (form_.comments) skipComments();
    }
    skipEmptyLines();
    if (at_ >= text_.size()) return false;
    record.line = line_;
    std::size_t count = 0;
    for (;;) {
        if (count == record.fields.size()) record.fields.emplace_back();
        if (form_.trims) skipBlanks();
        if (auto read = readField(record.fields[count++]); !read) return tl::unexpected(read.error());
        if (!passSeparator()) break;
    }
    record.fields.resize(count);
    skipLineEnd();
    return true;
}

void CsvReader::skipComments() {
    while (at_ < text_.size()) {
        const std::string_view rest = text_.substr(at_);
        if (!atLineEnd() && !isCsvComment(rest)) return;
        at_ += std::min(rest.find('\n'), rest.size() - 1) + 1;
        ++line_;
    }
}

bool CsvReader::atLineEnd() const {
    return text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_, 2) == "\r\n");
}

void CsvReader::skipLineEnd() {
    if (at_ >= text_.size()) return;
    at_ += text_[at_] == '\r' ? 2 : 1;
    ++line_;
}

void CsvReader::skipEmptyLines() {
    for (;;) {
        const std::size_t line_begin = at_;
        while (form_.trims && at_ < text_.size() && isBlank(text_[at_])) ++at_;
        if (at_ >= text_.size()) return;
        if (!atLineEnd()) {
            at_ = line_begin;
            return;
        }
        skipLineEnd();
    }
}

void CsvReader::skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_]) &&
           (text_[at_] != form_.separator || form_.separator == ' '))
        ++at_;
}

bool CsvReader::passSeparator() {
    if (form_.trims) skipBlanks();
    if (at_ >= text_.size() || atLineEnd()) return false;
    if (form_.separator == ' ') return true;
    if (text_[at_] != form_.separator) return false;
    ++at_;
    return true;
}

Result<void> CsvReader::readField(std::string& field) {
    if (at_ < text_.size() && text_[at_] == '"') return readQuoted(field);
    const std::size_t begin = at_;
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        // What ends a field comes before the comma in ASCII, but for another separator.
        if (static_cast<unsigned char>(c) > ',' && c != form_.separator) continue;
        if (c == form_.separator || c == '\n' || (c == '\r' && atLineEnd())) break;
        if (form_.separator == ' ' && isBlank(c)) break;
        if (c == '"')
            return fail(fmt::format("{}:{}", name_, line_), "a quote is inside an unquoted field",
                        "Quote the whole field and double the quote");
    }
    const std::string_view found = text_.substr(begin, at_ - begin);
    field = form_.trims ? trimmed(found) : found;
    return {};
}

Result<void> CsvReader::readQuoted(std::string& field) {
    const int opened = line_;
    field.clear();
    for (++at_; at_ < text_.size(); ++at_) {
        if (text_[at_] == '"') {
            if (text_.substr(at_, 2) != "\"\"") break;
            ++at_;
        } else if (text_[at_] == '\n') {
            ++line_;
        }
        field += text_[at_];
    }
    if (at_ >= text_.size())
        return fail(fmt::format("{}:{}", name_, opened), "a quoted field has no closing quote");
    ++at_;
    if (form_.trims && form_.separator != ' ') skipBlanks();
    if (at_ < text_.size() && text_[at_] != form_.separator && !atLineEnd() &&
        !(form_.separator == ' ' && isBlank(text_[at_])))
        return fail(fmt::format("{}:{}", name_, line_),
                    fmt::format("text follows a closing quote; expected {} or the end of the line",
                                separatorName(form_.separator)));
    return {};
}

Result<std::vector<CsvRecord>> parseCsv(std::string_view text, const std::string& name, CsvForm form) {
    CsvReader reader(text, name, form);
    std::vector<CsvRecord> records;
    for (;;) {
        CsvRecord record;
        const auto more = reader.next(record);
        if (!more) return tl::unexpected(more.error());
        if (!*more) return records;
        records.push_back(std::move(record));
    }
}

std::string csvField(std::string_view text) {
    std::string out;
    appendCsvField(out, text);
    return out;
}

void appendCsvField(std::string& out, std::string_view text) {
    const bool is_plain = std::none_of(text.begin(), text.end(),
                                       [](char c) { return c == ',' || c == '"' || c == '\r' || c == '\n'; });
    if (is_plain) {
        out += text;
        return;
    }
    out += '"';
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    out += '"';
}

std::string safeText(std::string_view text) {
    return (looksLikeFormula(text) ? "'" : "") + std::string(text);
}

std::string_view withoutGuard(std::string_view safe) {
    return safe.size() > 1 && safe.front() == '\'' && looksLikeFormula(safe.substr(1)) ? safe.substr(1)
                                                                                       : safe;
}

void appendSafeCsvField(std::string& out, std::string_view text) {
    if (looksLikeFormula(text))
        appendCsvField(out, safeText(text));
    else
        appendCsvField(out, text);
}

}  // namespace deixis
