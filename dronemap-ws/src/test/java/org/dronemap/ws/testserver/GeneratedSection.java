package org.dronemap.ws.testserver;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A part of a page that follows from the code: compared, or with {@code -Ddronemap.approve=true} written. */
public final class GeneratedSection {
    private GeneratedSection() {}

    /** {@code from}: what it is written from, as the marks say before and behind it. */
    public static void check(Path page, String from, String text) throws IOException {
        String mark = "<!-- written from " + from + ": begin -->\n";
        String whole = Files.readString(page);
        int begin = whole.indexOf(mark) + mark.length();
        int end = whole.indexOf("<!-- written from " + from + ": end -->\n");
        assertThat(begin).isBetween(mark.length(), end);
        if (Boolean.getBoolean("dronemap.approve")) {
            Files.writeString(page, whole.substring(0, begin) + text + whole.substring(end));
            return;
        }
        assertThat(whole.substring(begin, end))
                .as("approve what was meant to change with -Ddronemap.approve=true")
                .isEqualTo(text);
    }
}
