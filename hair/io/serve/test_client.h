// STAFF ONLY. Sends requests to a server of this machine, as browsers and as strangers do.
#pragma once

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace hair {

struct TestClient {
  std::string host, base;  // "127.0.0.1:41234", "/TOKEN/"

  // Takes the first address in a text.
  static TestClient at(const std::string& text) {
    const std::size_t host = text.find("http://") + 7, base = text.find('/', host);
    return {text.substr(host, base - host), text.substr(base, text.find_first_of(" \n", base) - base)};
  }

  std::string own() const { return "Host: " + host + "\r\nOrigin: http://" + host + "\r\n"; }

  // Sends a text as it is. The answer comes from the descriptor.
  int send_text(const std::string& text) const {
    const auto port = static_cast<in_port_t>(std::stoi(host.substr(host.find(':') + 1)));
    const sockaddr_in server{AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}};
    const int to = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(to, reinterpret_cast<const sockaddr*>(&server), sizeof server), 0);
    ::send(to, text.data(), text.size(), MSG_NOSIGNAL);
    return to;
  }

  int ask(const std::string& line, const std::string& headers, const std::string& body = "") const {
    return send_text(line + " HTTP/1.1\r\n" + headers + "Content-Length: " + std::to_string(body.size()) +
                     "\r\n\r\n" + body);
  }

  // The whole answer; the server must close the connection after it.
  std::string answer(const std::string& line, const std::string& headers,
                     const std::string& body = "") const {
    const int from = ask(line, headers + "Connection: close\r\n", body);
    std::string all, piece(1 << 16, '\0');
    for (ssize_t size = 0; (size = recv(from, piece.data(), piece.size(), 0)) > 0;)
      all.append(piece, 0, static_cast<std::size_t>(size));
    close(from);
    return all;
  }

  // -1 if the connection is cut off.
  static int status_from(int descriptor) {
    char start[sizeof "HTTP/1.1 200"] = "HTTP/1.1 -1";
    recv(descriptor, start, sizeof start - 1, MSG_WAITALL);
    close(descriptor);
    return std::atoi(start + 9);
  }

  int status(const std::string& line, const std::string& headers, const std::string& body = "") const {
    return status_from(ask(line, headers, body));
  }
};

}  // namespace hair
