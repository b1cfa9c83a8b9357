package org.dronemap.ws.testserver;

import java.util.List;

/** Texts that mean something to a database, a browser, a shell, a template, a log, a file system or a parser. */
public final class InjectionTexts {
    public static final List<String> ALL = List.of(
            "'; DROP TABLE users; --",
            "\" OR 1=1 --",
            "{\"$gt\":\"\"}",
            "<script>alert(1)</script>",
            "\"><img src=x onerror=alert(1)>",
            "../../../../etc/passwd",
            "..\\..\\windows\\win.ini",
            "line\r\nSet-Cookie: dronemap-session=planted",
            "${jndi:ldap://127.0.0.1:1/a}",
            "{{7*7}}#{7*7}%{7*7}",
            "`id`;$(id)|id&",
            "%00%0a%2e%2e%2f%s%n%d",
            "nul\u0000nul",
            "escape\u001b[31m",
            "right\u202eto left, zero\u200bwidth, e\u0301\u0301\u0301, \ufeff\uffff",
            "\ud83d\ude81\ud83d\udef0",
            "=1+1+cmd|' /C calc'!A0",
            "x".repeat(20_000));

    private InjectionTexts() {}
}
