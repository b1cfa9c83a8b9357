package org.dronemap.ws.history;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;

/** The place in a series of events from which a client goes on, and its form on the wire, which only we understand. */
record EventCursor(String series, long number) {
    private static final int LONGEST = 200;
    private static final Pattern PLAIN = Pattern.compile("([0-9A-Za-z-]{1,64}) (\\d{1,16})");

    String written() {
        return Base64.getUrlEncoder()
                .withoutPadding()
                .encodeToString((series + " " + number).getBytes(StandardCharsets.US_ASCII));
    }

    static EventCursor read(String text) {
        if (text.length() <= LONGEST) {
            try {
                String plain = new String(Base64.getUrlDecoder().decode(text), StandardCharsets.US_ASCII);
                Matcher parts = PLAIN.matcher(plain);
                if (parts.matches()) {
                    return new EventCursor(parts.group(1), Long.parseLong(parts.group(2)));
                }
            } catch (IllegalArgumentException notOurs) {
                throw unreadable(text);
            }
        }
        throw unreadable(text);
    }

    private static InvalidInput unreadable(String text) {
        String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "…" : text;
        return InvalidInput.outside(
                ValueProblem.VALUE_MALFORMED, "after", "first, or what an answer gave as next", "\"" + shown + "\"");
    }
}
