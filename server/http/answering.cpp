#include "answering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "answer_headers.hpp"
#include "core/text.hpp"
#include "server/http/json_text.hpp"

namespace deixis::server {

namespace {

/// A connection as cpp-httplib reads and writes it. What is written is gathered, so that an answer goes out
/// at once.
class ConnectionStream : public httplib::Stream {
  public:
    ConnectionStream(Connection& connection, const ServerLimits& limits,
                     const std::atomic<Clock::rep>& stop_at)
        : connection_(connection), limits_(limits), stop_at_(stop_at), reading_(patienceFor(0)) {}

    /// Before a body of so many bytes is read.
    void expectBody(std::size_t bytes) {
        taken_ = 0;
        reading_.emplace(patienceFor(bytes));
    }
    [[nodiscard]] std::size_t bodyTaken() const { return taken_; }
    [[nodiscard]] bool broken() const { return broken_; }

    bool flush() {
        const std::string bytes = std::exchange(gathered_, {});
        if (!broken_ && !bytes.empty()) broken_ = !connection_.write(bytes, patienceFor(bytes.size()));
        return !broken_;
    }

    bool is_readable() const override { return !broken_; }
    bool is_writable() const override { return !broken_; }
    ssize_t read(char* to, size_t size) override {
        if (!flush()) return -1;  // "100 Continue"
        const long count = connection_.read(to, size, *reading_);
        if (count <= 0)
            broken_ = true;
        else
            taken_ += static_cast<std::size_t>(count);
        return count;
    }
    ssize_t write(const char* bytes, size_t size) override {
        gathered_.append(bytes, size);
        if (gathered_.size() >= gather_bytes && !flush()) return -1;
        return static_cast<ssize_t>(size);
    }
    /// Nobody asks who it is.
    void get_remote_ip_and_port(std::string& ip, int& port) const override {
        ip.clear();
        port = 0;
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override {
        ip = localAddress(connection_.socket());
        port = 0;
    }
    /// It selects on none: this stream waits by itself.
    socket_t socket() const override { return INVALID_SOCKET; }

  private:
    [[nodiscard]] Patience patienceFor(std::size_t bytes) const {
        const auto now = Clock::now();
        return {now + limits_.transfer_time + std::chrono::seconds(bytes / limits_.bytes_a_second),
                now + limits_.stopping_time, stop_at_};
    }

    static constexpr std::size_t gather_bytes = std::size_t{1} << 20U;
    Connection& connection_;
    const ServerLimits& limits_;
    const std::atomic<Clock::rep>& stop_at_;
    std::optional<Patience> reading_;
    std::size_t taken_ = 0;
    std::string gathered_;
    bool broken_ = false;
};

/// For what cpp-httplib itself refuses.
Refusal refusalOfStatus(int status) {
    switch (status) {
        case 404:
            return {status, "there is nothing at this address"};
        case 413:
            return {status, "the body is too large"};
        case 414:
            return {status, "the address is too long"};
        case 416:
            return {status, "there is no such part"};
        default:
            return {status, status < 500 ? "the request is no HTTP that can be read" : "the server failed"};
    }
}

/// `"abc"`, `W/"abc"` or `abc`.
std::string revisionOf(std::string_view header) {
    std::string_view tag = trimmed(header);
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    if (tag.size() >= 2 && tag.starts_with('"') && tag.ends_with('"')) tag = tag.substr(1, tag.size() - 2);
    return std::string(tag);
}

Result<nlohmann::json> jsonBody(const Shape& shape, const std::string& text) {
    auto body = parseJsonText(text);
    if (!body) return body;
    if (const auto checked = checkShape(shape, *body); !checked) return tl::unexpected(checked.error());
    fillIn(shape, *body);
    return body;
}

Result<nlohmann::json> queryOf(const Shape& shape, const httplib::Params& came) {
    nlohmann::json query = nlohmann::json::object();
    for (const auto& [name, text] : came) {
        const auto number = naturalNumber(text);
        if (!number) return fail(storable(name), "found no whole number");
        if (query.contains(name)) return fail(storable(name), "stands twice");
        query[name] = *number;
    }
    if (const auto checked = checkShape(shape, query); !checked) return tl::unexpected(checked.error());
    fillIn(shape, query);
    return query;
}

Result<std::map<std::string, std::string>> formBody(const std::vector<FormPart>& parts,
                                                    const httplib::MultipartFormDataMap& came) {
    std::map<std::string, std::string> out;
    for (const auto& [name, part] : came) {
        const auto declared = std::find_if(parts.begin(), parts.end(),
                                           [&name = name](const FormPart& one) { return one.name == name; });
        if (declared == parts.end()) return fail(storable(name), "there is no such part");
        if (!declared->file) {
            if (!storableText(part.content)) return fail(name, "is no text in UTF-8");
            if (const auto checked = checkShape(declared->shape, part.content); !checked)
                return fail(name, checked.error().message, checked.error().hint);
        }
        if (!out.emplace(name, part.content).second) return fail(name, "stands twice");
    }
    for (const FormPart& part : parts)
        if (part.required && out.count(part.name) == 0) return fail(part.name, "is missing");
    return out;
}

}  // namespace

Answering::Answering(const Admission& admission, const ServerLimits& limits,
                     const std::atomic<Clock::rep>& stop_at)
    : admission_(admission), limits_(limits), stop_at_(stop_at) {
    set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(limits.idle_time).count());
    set_payload_max_length(admission.largestBody());
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        return beforeBody(request, response);
    });
    set_expect_100_continue_handler([this](const httplib::Request&, httplib::Response& response) {
        if (!verdict_.refusal) return 100;
        writeRefusal(response, *verdict_.refusal);
        return response.status;
    });
    set_error_handler(HandlerWithResponse([this](const httplib::Request&, httplib::Response& response) {
        if (response.body.empty()) writeRefusal(response, refusalOfStatus(response.status));
        return HandlerResponse::Handled;
    }));
    set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
        for (const auto& [name, value] : headersOfAll()) response.set_header(name, value);
        if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
    });
    set_exception_handler(
        [this](const httplib::Request&, httplib::Response& response, std::exception_ptr failure) {
            try {
                std::rethrow_exception(std::move(failure));
            } catch (const std::bad_alloc&) {
                writeRefusal(response, {503, "there is not enough memory for this"});
            } catch (const std::exception& error) {
                writeRefusal(response, {500, fmt::format("the server failed: {}", error.what())});
            }
        });
    const auto with_body = [this](const httplib::Request& request, httplib::Response& response) {
        callRoute(request, response);
    };
    constexpr const char* anything = R"([\s\S]*)";
    Post(anything, with_body);
    Put(anything, with_body);
    Delete(anything, with_body);
}

bool Answering::answer(Connection& connection, bool last) {
    ConnectionStream stream(connection, limits_, stop_at_);
    bool closed = false;
    bool judged = false;
    verdict_ = {};
    const bool written = process_request(stream, last, closed, [&](httplib::Request& request) {
        verdict_ = admission_.judge(request);
        judged = true;
        stream.expectBody(verdict_.body_bytes);
        accepted_ = acceptedCodings(request.get_header_value("Accept-Encoding"));
        // Else the library compresses, with Brotli seconds a megabyte.
        request.headers.erase("Accept-Encoding");
        const bool in_parts = !verdict_.refusal && verdict_.route != nullptr && verdict_.route->in_parts &&
                              request.ranges.size() == 1;
        if (!in_parts) request.ranges.clear();
        if (verdict_.ends) {
            request.headers.erase("Connection");
            request.set_header("Connection", "close");
        }
    });
    const bool flushed = stream.flush();
    // Where a body was left unread the next request's head cannot be found.
    return written && flushed && judged && !verdict_.ends && !closed && !last && !stream.broken() &&
           stream.bodyTaken() == verdict_.body_bytes;
}

void Answering::writeRefusal(httplib::Response& response, const Refusal& refusal) const {
    response.status = refusal.status;
    response.set_content(bodyOf(refusal), "application/json");
}

void Answering::writeReply(const httplib::Request& request, httplib::Response& response, Reply reply) const {
    // A part that is asked for makes it 206, which the library says by itself.
    if (request.ranges.empty()) response.status = reply.status;
    for (const auto& [name, value] : reply.headers) response.set_header(name, value);
    if (verdict_.route->in_parts) response.set_header("Accept-Ranges", "bytes");
    if (!reply.bytes) return;
    const Coding coding = accepted_.quickest();
    std::optional<std::string> fewer;
    if (!verdict_.route->in_parts && isCompressible(reply.content_type)) {
        response.set_header("Vary", "Accept-Encoding");
        fewer = compressed(*reply.bytes, coding, Effort::quick);
    }
    if (fewer) response.set_header("Content-Encoding", codingName(coding));
    response.set_content(fewer ? std::move(*fewer) : *reply.bytes, reply.content_type);
}

void Answering::signIn(httplib::Response& response) const {
    response.set_redirect("/", 303);
    response.set_header("Set-Cookie", admission_.signInCookie());
}

void Answering::writePage(const httplib::Request& request, httplib::Response& response) const {
    const PageFile& page = *verdict_.page;
    const Coding coding = accepted_.smallest();
    const auto& fewer = coding == Coding::brotli ? page.brotli : page.gzip;
    const bool is_coded = coding != Coding::none && fewer;
    std::string etag = page.etag;
    if (is_coded) etag.insert(etag.size() - 1, std::string("-") + codingName(coding));
    response.set_header("ETag", etag);
    response.set_header("Vary", "Accept-Encoding");
    response.set_header("Cache-Control", "no-cache");  // asked for again each time, by the ETag
    if (request.get_header_value("If-None-Match") == etag) {
        response.status = 304;
        return;
    }
    response.status = 200;
    if (is_coded) response.set_header("Content-Encoding", codingName(coding));
    response.set_content(is_coded ? *fewer : *page.bytes, page.content_type);
}

void Answering::callRoute(const httplib::Request& request, httplib::Response& response) const {
    const Route& route = *verdict_.route;
    Call call;
    call.path = verdict_.path_parts;
    if (route.takes_revision && request.has_header("If-Match"))
        call.revision = revisionOf(request.get_header_value("If-Match"));
    if (!route.query.empty()) {
        auto query = queryOf(objectShape("", route.query), request.params);
        if (!query) return writeRefusal(response, refusalOf(query.error()));
        call.query = std::move(*query);
    }
    if (request.is_multipart_form_data()) {
        auto form = formBody(route.form, request.files);
        if (!form) return writeRefusal(response, refusalOf(form.error()));
        call.form = std::move(*form);
    } else if (route.body) {
        auto body = jsonBody(*route.body, request.body);
        if (!body) return writeRefusal(response, refusalOf(body.error()));
        call.body = std::move(*body);
    }
    auto answer = route.run(call);
    if (answer)
        writeReply(request, response, std::move(*answer));
    else
        writeRefusal(response, answer.error());
}

httplib::Server::HandlerResponse Answering::beforeBody(const httplib::Request& request,
                                                       httplib::Response& response) const {
    if (verdict_.refusal) {
        for (const auto& [name, value] : verdict_.headers) response.set_header(name, value);
        writeRefusal(response, *verdict_.refusal);
    } else if (verdict_.signs_in) {
        signIn(response);
    } else if (verdict_.page != nullptr) {
        writePage(request, response);
    } else if (!verdict_.route->body && verdict_.route->form.empty()) {
        callRoute(request, response);
    } else {
        return HandlerResponse::Unhandled;
    }
    return HandlerResponse::Handled;
}

}  // namespace deixis::server
