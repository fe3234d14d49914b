// unit/two_addresses.h: makes the host name "two-addresses" resolve to ::1 and then 127.0.0.1, as localhost
// does on most machines.
#pragma once
#include <dlfcn.h>
#include <netdb.h>

#include <cstring>

/// Replaces the system's function in the whole test program; passes other names on to it.
extern "C" inline __attribute__((used, visibility("default"))) int getaddrinfo(const char* host,
                                                                               const char* service,
                                                                               const addrinfo* wanted,
                                                                               addrinfo** found) {
    using Function = int (*)(const char*, const char*, const addrinfo*, addrinfo**);
    static const auto real = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "getaddrinfo"));
    if (host == nullptr || std::strcmp(host, "two-addresses") != 0) return real(host, service, wanted, found);
    addrinfo hints = wanted == nullptr ? addrinfo{} : *wanted;
    hints.ai_family = AF_UNSPEC;
    if (const int failure = real("::1", service, &hints, found); failure != 0) return failure;
    addrinfo* last = *found;
    while (last->ai_next != nullptr) last = last->ai_next;
    return real("127.0.0.1", service, &hints, &last->ai_next);
}
