#include "live_view.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <httplib.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <functional>
#include <mutex>
#include <regex>
#include <thread>
#include <utility>

#include "live_state.hpp"
#include "report/page.hpp"
#include "report/pairs.hpp"
#include "report/pictures.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

using httplib::Request;
using httplib::Response;
using nlohmann::ordered_json;

constexpr int picture_side = 640;  // pixels
constexpr int pair_side = 400;
constexpr int lower_priority = 10;

bool is_ip_address(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> unused{};
  return inet_pton(AF_INET, host.c_str(), unused.data()) == 1 ||
         inet_pton(AF_INET6, host.c_str(), unused.data()) == 1;
}

// Without the port, and the brackets of IPv6.
std::string host_of(const std::string& header) {
  if (header.starts_with('[')) {
    const std::size_t end = header.find(']');
    return end == std::string::npos ? "" : header.substr(1, end - 1);
  }
  return header.substr(0, header.find(':'));
}

// A foreign site can point a name of its own at this machine and have a browser ask here (DNS rebinding): the
// name is then in the header. Numbers, and names that this machine was told to serve, cannot be pointed.
bool is_own(const std::string& header, const std::string& address) {
  const std::string host = host_of(header);
  return host == "localhost" || is_ip_address(host) || (!host.empty() && host == address);
}

void refuse(Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

// At most nine digits; nothing else is a number here.
std::optional<std::size_t> number_in(const std::string& text) {
  static const std::regex digits("[0-9]{1,9}");
  if (!std::regex_match(text, digits)) return std::nullopt;
  return static_cast<std::size_t>(std::stoul(text));
}

void send(Response& response, const ordered_json& json) {
  response.set_content(report::dump(json), "application/json");
}

}  // namespace

class LiveView::Server {
 public:
  Server(const ViewOptions& options, std::string title) : options_(options), title_(std::move(title)) {
    // The library's own choice would let two programs share a port.
    http_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
    // A viewer that stalls, or a connection that a browser keeps open, must not hold up the end of the run.
    http_.set_keep_alive_max_count(1);
    http_.set_keep_alive_timeout(1);
    http_.set_read_timeout(1);
    http_.set_write_timeout(2);
    http_.new_task_queue = [] { return new httplib::ThreadPool(8); };
    bind();
    set_rules();
  }

  ~Server() {
    if (!thread_.joinable()) return;
    http_.stop();
    thread_.join();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  Server(Server&&) = delete;
  Server& operator=(Server&&) = delete;

  void begin(const TopologicalMap& map, const std::string& frontend) {
    state_ = std::make_unique<LiveState>(title_, map, frontend);
    looker_ = std::make_unique<report::Looker>(frontend, map.config().regions, "");
    set_routes();
    thread_ = std::thread([this] {
      // Threads that it starts inherit this: viewers get what the run leaves.
      setpriority(PRIO_PROCESS, 0, lower_priority);
      http_.listen_after_bind();
    });
    const bool is_v6 = options_.address.find(':') != std::string::npos;
    spdlog::info("live view at http://{}:{}/", is_v6 ? "[" + options_.address + "]" : options_.address,
                 port_);
  }

  void update(const TopologicalMap& map) { state_->update(map); }

 private:
  void bind() {
    errno = 0;
    const int wanted = *options_.port;
    port_ = wanted == 0                                    ? http_.bind_to_any_port(options_.address)
            : http_.bind_to_port(options_.address, wanted) ? wanted
                                                           : -1;
    if (port_ > 0) return;
    const char* why = errno != 0 ? std::strerror(errno) : "no such address";
    throw Error(fmt::format("--view: port {} of {} cannot be used: {}", wanted, options_.address, why));
  }

  // What holds for every request.
  void set_rules() {
    http_.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (request.method != "GET") {
        refuse(response, 405, "only GET");
        response.set_header("Allow", "GET");
        return httplib::Server::HandlerResponse::Handled;
      }
      if (!is_own(request.get_header_value("Host"), options_.address)) {
        refuse(response, 403, "not for this host");
        return httplib::Server::HandlerResponse::Handled;
      }
      return httplib::Server::HandlerResponse::Unhandled;
    });
    http_.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                               {"Cache-Control", "no-store"},
                               {"Referrer-Policy", "no-referrer"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"X-Frame-Options", "DENY"}});
    http_.set_exception_handler([](const Request&, Response& response, const std::exception_ptr& fault) {
      try {
        std::rethrow_exception(fault);
      } catch (const Error& error) {
        refuse(response, 404, error.what());
      } catch (const std::exception&) {
        refuse(response, 500, "something failed");
      }
    });
    http_.set_error_handler([](const Request&, Response& response) {
      if (response.body.empty()) refuse(response, response.status, "there is nothing here");
    });
  }

  void set_routes() {
    http_.Get("/", [this](const Request&, Response& response) {
      response.set_content(report::live_page(state_->empty_page()), "text/html; charset=utf-8");
    });
    http_.Get("/news", [this](const Request& request, Response& response) {
      const auto images = number_in(request.get_param_value("images"));
      const auto layout = number_in(request.get_param_value("layout"));
      if (!images || !layout) return refuse(response, 400, "images and layout must be numbers");
      send(response, state_->news(*images, static_cast<int>(*layout)));
    });
    http_.Get("/picture/([0-9]{1,9})", [this](const Request& request, Response& response) {
      const auto name = state_->name(std::stoul(request.matches[1].str()));
      if (!name) return refuse(response, 404, "the map has no such image");
      send(response, report::picture_of(look(*name), picture_side));
    });
    http_.Get("/pair/([0-9]{1,9})", [this](const Request& request, Response& response) {
      const std::size_t number = std::stoul(request.matches[1].str());
      const auto loop = state_->loop(number);
      if (!loop) return refuse(response, 404, "the map has no such loop");
      send(response, pair(number, *loop));
    });
  }

  // Images are read one at a time: the run has the machine.
  report::Look look(const std::string& name) {
    const std::scoped_lock hold(looking_);
    return looker_->look(name);
  }

  ordered_json pair(std::size_t number, const LiveState::LoopCopy& copy) {
    const report::Loop& loop = copy.subject.loops.front();
    const int view = loop.views.front();
    const report::Look image = look(copy.image_name);
    const report::Look place = look(copy.place_name);
    ordered_json pair = {{"loop", number}};
    pair.update(report::pair_of(loop, {view, copy.image_name, copy.place_name}, image, place, copy.subject));
    ordered_json pictures;
    pictures[std::to_string(loop.image)] = report::picture_of(image, pair_side);
    pictures[std::to_string(view)] = report::picture_of(place, pair_side);
    return {{"pair", std::move(pair)}, {"pictures", std::move(pictures)}};
  }

  const ViewOptions options_;
  const std::string title_;
  httplib::Server http_;
  int port_ = 0;
  std::unique_ptr<LiveState> state_;
  std::mutex looking_;
  std::unique_ptr<report::Looker> looker_;
  std::thread thread_;
};

void add_view_options(CLI::App& command, ViewOptions& options) {
  constexpr const char* group = "Live view";
  command
      .add_option("--view", options.port,
                  fmt::format("Show map, loops and images in a browser while the run goes on, at this port; "
                              "without a number {}, 0: any free one",
                              default_view_port))
      ->expected(0, 1)
      ->default_str(std::to_string(default_view_port))
      ->check(CLI::Range(0, 65535).description(""))
      ->type_name("PORT")
      ->group(group);
  command
      .add_option("--view-address", options.address,
                  "Of this machine, where the view is served; any but the default lets others look")
      ->capture_default_str()
      ->type_name("ADDRESS")
      ->group(group);
}

LiveView::LiveView(const ViewOptions& options, std::string title)
    : server_(options.port ? std::make_unique<Server>(options, std::move(title)) : nullptr) {}

LiveView::~LiveView() = default;

void LiveView::begin(const TopologicalMap& map, const std::string& frontend) {
  if (server_) server_->begin(map, frontend);
}

void LiveView::update(const TopologicalMap& map) {
  if (server_) server_->update(map);
}

}  // namespace sailmap::app
