#include "studies/texts/study_texts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/texts/language_words.hpp"

namespace deixis::studies {

namespace {

void collectReferences(const toml::node& node, std::set<std::string, std::less<>>& out) {
    if (const auto* text = node.as_string(); text != nullptr && text->get().rfind('@', 0) == 0)
        out.insert(text->get().substr(1));
    if (const toml::array* list = node.as_array())
        for (const toml::node& entry : *list) collectReferences(entry, out);
    if (const toml::table* table = node.as_table())
        for (const auto& [key, entry] : *table) collectReferences(entry, out);
}

std::vector<std::string_view> views(const std::set<std::string, std::less<>>& names) {
    return {names.begin(), names.end()};
}

}  // namespace

void TextBook::readLanguage(const std::string& language, const toml::table& table) {
    for (const auto& [key, node] : table) {
        const std::string dotted = fmt::format("texts.{}.{}", language, key.str());
        const toml::source_position at = key.source().begin;
        if (!isName(key.str()))
            problems_.add(at, dotted, fmt::format("found the key \"{}\", expected a name", key.str()),
                          "Keys of texts have 1 to 48 letters A-Z a-z, digits, '-' and '_'");
        std::string text;
        if (!node.is_string()) {
            problems_.add(at, dotted, fmt::format("found {}, expected a text in quotes", describe(node)));
        } else {
            text = unwrapped(node.as_string()->get());
            if (text.empty()) problems_.add(at, dotted, "found an empty text, expected some words");
            if (const auto why = notDrawn(text)) problems_.add(at, dotted, why->message, why->hint);
        }
        texts_[language].emplace(key.str(), text);
        keys_.emplace(key.str());
    }
}

void TextBook::compareLanguages(const toml::table& texts, const toml::table& file) {
    std::set<std::string, std::less<>> used;
    for (const auto& [key, node] : file)
        if (key.str() != "texts" && key.str() != "words") collectReferences(node, used);
    const std::vector<std::string_view> all = views(keys_);
    std::set<std::string, std::less<>> spared;  // a mistyped reference leaves nothing unused
    for (const std::string& key : used)
        if (keys_.count(key) == 0) spared.emplace(nearestName(key, all));

    std::set<std::string, std::less<>> told;
    for (const std::string& language : languages_) {
        const toml::node* node = texts.get(language);
        if (node == nullptr || !node->is_table()) continue;
        std::set<std::string, std::less<>> lacking;
        for (const std::string& key : keys_)
            if (used.count(key) > 0 && texts_[language].count(key) == 0) lacking.insert(key);
        for (const auto& [key, entry] : *node->as_table()) {
            const std::string name(key.str());
            if (used.count(name) > 0 || spared.count(name) > 0 || !told.insert(name).second) continue;
            const std::string meant(nearestName(name, views(lacking)));
            lacking.erase(meant);
            problems_.add(
                key.source().begin, fmt::format("texts.{}.{}", language, name),
                fmt::format("this text is not used anywhere; expected \"@{}\" somewhere in the file", name),
                meant.empty() ? "Remove it from all languages, or refer to it"
                              : fmt::format("Did you mean {}?", meant));
        }
        for (const std::string& key : lacking) {
            const auto has =
                std::find_if(languages_.begin(), languages_.end(),
                             [&](const std::string& other) { return texts_[other].count(key) > 0; });
            problems_.add(node->source().begin, fmt::format("texts.{}.{}", language, key),
                          fmt::format("missing; expected a text, as in [texts.{}]", *has));
        }
    }
}

void TextBook::read(const toml::table& file, const std::vector<std::string>& languages,
                    const std::string& language) {
    languages_ = languages;
    language_ = language;
    const toml::node* node = file.get("texts");
    if (node == nullptr) {
        if (languages.size() > 1)
            problems_.add({}, "texts",
                          fmt::format("missing; expected a section [texts.{}] and one for each further "
                                      "language",
                                      languages.front()));
        return;
    }
    const toml::table* texts = node->as_table();
    if (texts == nullptr) {
        problems_.add(node->source().begin, "texts",
                      fmt::format("found {}, expected sections such as [texts.{}]", describe(*node),
                                  languages.front()));
        return;
    }
    std::vector<std::string_view> lacking;
    for (const std::string& code : languages)
        if (!texts->contains(code)) lacking.emplace_back(code);
    std::set<std::string_view> meant;
    for (const auto& [code, table] : *texts) {
        const std::string dotted = fmt::format("texts.{}", code.str());
        if (std::find(languages.begin(), languages.end(), code.str()) == languages.end()) {
            const std::string_view nearest = nearestName(code.str(), lacking);
            meant.insert(nearest);
            const bool language_text = table.is_table();
            problems_.add(code.source().begin, dotted,
                          language_text ? fmt::format("\"{}\" is not among languages ({})", code.str(),
                                                      fmt::join(languages, ", "))
                                        : fmt::format("found {}, expected sections such as [texts.{}]",
                                                      describe(table), languages.front()),
                          nearest.empty() ? "" : fmt::format("Did you mean {}?", nearest));
        } else if (!table.is_table()) {
            problems_.add(code.source().begin, dotted,
                          fmt::format("found {}, expected a section [{}]", describe(table), dotted));
        } else {
            readLanguage(std::string(code.str()), *table.as_table());
        }
    }
    for (const std::string_view code : lacking)
        if (meant.count(code) == 0 && !keys_.empty())
            problems_.add(texts->source().begin, fmt::format("texts.{}", code),
                          fmt::format("missing; expected a section [texts.{}], since \"{}\" is among "
                                      "languages",
                                      code, code));
    compareLanguages(*texts, file);
}

std::string TextBook::resolve(const std::string& written, toml::source_position at, const std::string& key) {
    if (written.rfind('@', 0) != 0) {
        std::string text = unwrapped(written);
        if (const auto why = notDrawn(text)) {
            problems_.add(at, key, why->message, why->hint);
        } else if (text.empty()) {
            problems_.add(at, key, "found an empty text, expected some words");
        } else if (languages_.size() > 1) {
            problems_.add(at, key,
                          fmt::format("found a text in one language, expected \"@\" and a key of [texts.{}]: "
                                      "there are {} languages",
                                      languages_.front(), languages_.size()));
        }
        return text;
    }
    const std::string wanted = written.substr(1);
    if (keys_.count(wanted) == 0) {
        const std::vector<std::string_view> known = views(keys_);
        problems_.add(at, key,
                      fmt::format("there is no text \"{}\" in [texts.{}]", wanted, languages_.front()),
                      known.empty() ? "" : proposeName(wanted, known));
        return {};
    }
    const Texts& texts = texts_[language_];
    const auto found = texts.find(wanted);
    return found == texts.end() ? std::string() : found->second;
}

std::vector<std::string> readLanguages(TomlTable& table, const toml::table& file) {
    if (!table.has("languages")) return {"en"};
    std::vector<std::string> languages = table.names("languages", 1, true);
    if (table.sound("languages")) return languages;
    // What the list was meant to be can be told from the texts, so that they give no further problems.
    if (const toml::table* texts = file["texts"].as_table(); texts != nullptr && !texts->empty()) {
        languages.clear();
        for (const auto& [code, node] : *texts) languages.emplace_back(code.str());
    }
    if (languages.empty()) languages.emplace_back("en");
    return languages;
}

}  // namespace deixis::studies
