// SPDX-License-Identifier: MIT OR Apache-2.0
// A small JSON reader (objects, arrays, strings without \u, numbers, true/false/null), enough for our own files.
#pragma once
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct Json {
    enum Kind { Null, Bool, Number, String, Array, Object } kind = Null;
    bool b = false;
    double num = 0;      ///< the nearest double: what any reader of the file works from
    std::string str;
    std::vector<Json> items;
    std::vector<std::pair<std::string, Json>> members;

    const Json* find(const std::string& k) const {
        for (auto& m : members) if (m.first == k) return &m.second;
        return nullptr;
    }
    const Json& operator[](const std::string& k) const {
        auto* p = find(k);
        if (!p) throw std::runtime_error("no member " + k);
        return *p;
    }
    const Json& operator[](size_t i) const { return items.at(i); }
};

class JsonReader {
    const std::string& t;
    size_t i = 0;
    void space() { while (i < t.size() && isspace((unsigned char)t[i])) ++i; }
    void want(char c) { space(); if (t[i] != c) throw std::runtime_error(std::string("JSON: expected ") + c); ++i; }
    std::string text() {
        want('"');
        std::string s;
        while (t[i] != '"') { if (t[i] == '\\') ++i; s += t[i++]; }
        ++i;
        return s;
    }
public:
    explicit JsonReader(const std::string& s) : t(s) {}
    Json value() {
        space();
        Json j;
        if (t[i] == '{') {
            j.kind = Json::Object; ++i; space();
            if (t[i] == '}') { ++i; return j; }
            for (;;) {
                std::string k = text(); want(':');
                j.members.emplace_back(k, value());
                space();
                if (t[i] == ',') { ++i; space(); continue; }
                want('}'); return j;
            }
        }
        if (t[i] == '[') {
            j.kind = Json::Array; ++i; space();
            if (t[i] == ']') { ++i; return j; }
            for (;;) {
                j.items.push_back(value());
                space();
                if (t[i] == ',') { ++i; continue; }
                want(']'); return j;
            }
        }
        if (t[i] == '"') { j.kind = Json::String; j.str = text(); return j; }
        if (t.compare(i, 4, "null") == 0) { i += 4; return j; }
        if (t.compare(i, 4, "true") == 0) { i += 4; j.kind = Json::Bool; j.b = true; return j; }
        if (t.compare(i, 5, "false") == 0) { i += 5; j.kind = Json::Bool; return j; }
        char* end;
        j.kind = Json::Number;
        j.num = strtod(t.c_str() + i, &end);
        if (end == t.c_str() + i) throw std::runtime_error("JSON: bad value");
        i = end - t.c_str();
        return j;
    }
};

inline Json read_json(const std::string& path) {
    std::ifstream f(path);
    if (!f) throw std::runtime_error("cannot read " + path);
    std::stringstream ss;
    ss << f.rdbuf();
    const std::string s = ss.str();
    return JsonReader(s).value();
}
