// CSV according to RFC 4180.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis {

struct CsvRecord {
    int line = 1;  ///< on which it begins
    std::vector<std::string> fields;
};

/// How the records of a text are laid out.
struct CsvForm {
    char separator = ',';   ///< a blank: any number of blanks and tabs, also before and after all fields
    bool comments = false;  ///< lines before the first record that begin with #, or Excel's "sep=;", are none
    bool trims = false;  ///< fields without blanks around them; lines of nothing but blanks are passed over
};

[[nodiscard]] const char* separatorName(char separator);  ///< "a comma"
/// Whether CsvForm::comments passes over a line that begins so.
[[nodiscard]] bool isCsvComment(std::string_view line);

[[nodiscard]] constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/// Reads record by record. Fields may be quoted, with "" for a quote; lines end in LF or CRLF, empty ones and
/// a UTF-8 mark at the start are skipped. `name` stands for the file in errors. A text that is not UTF-8
/// (storableText()) is an error, which names the line.
class CsvReader {
  public:
    /// `text` must outlive this.
    CsvReader(std::string_view text, std::string name, CsvForm form = {});
    /// The next record into `record`, whose memory is used again; false if there is none left.
    [[nodiscard]] Result<bool> next(CsvRecord& record);

  private:
    [[nodiscard]] Result<void> checkText() const;
    void skipComments();
    [[nodiscard]] bool atLineEnd() const;
    void skipLineEnd();
    void skipEmptyLines();
    void skipBlanks();
    /// Whether a further field of the record follows.
    [[nodiscard]] bool passSeparator();
    [[nodiscard]] Result<void> readField(std::string& field);
    [[nodiscard]] Result<void> readQuoted(std::string& field);

    std::string_view text_;
    std::string name_;
    CsvForm form_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool checked_ = false;
};

/// All records at once.
[[nodiscard]] Result<std::vector<CsvRecord>> parseCsv(std::string_view text, const std::string& name,
                                                      CsvForm form = {});

/// The field, quoted where it must be.
[[nodiscard]] std::string csvField(std::string_view text);
/// Likewise, behind what stands in `out`.
void appendCsvField(std::string& out, std::string_view text);

/// A cell of text as a spreadsheet may read it: one that would be taken for a formula (it begins with = + -
/// @, a tab or a carriage return) gets an apostrophe before it. For tables that people open, not for files
/// that the program reads again.
[[nodiscard]] std::string safeText(std::string_view text);
/// The text that safeText() was made from, which may be left as it was.
[[nodiscard]] std::string_view withoutGuard(std::string_view safe);
/// safeText() as a field, behind what stands in `out`.
void appendSafeCsvField(std::string& out, std::string_view text);

}  // namespace deixis
