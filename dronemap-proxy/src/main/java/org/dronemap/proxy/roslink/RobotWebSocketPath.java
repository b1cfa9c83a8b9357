package org.dronemap.proxy.roslink;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** The owner and key in the URL path of a robot's WebSocket to the server, or neither. */
record RobotWebSocketPath(@Nullable String owner, @Nullable String key) {
    private static final int LONGEST = 400;
    private static final Pattern KEYED = Pattern.compile("/websockets/roslink/user/([^/?#]+)/robot/([^/?#]+)/robot/?");
    static final RobotWebSocketPath BARE = new RobotWebSocketPath(null, null);

    /** Empty for any other path. */
    static Optional<RobotWebSocketPath> of(String path) {
        if (path.isEmpty() || path.equals("/")) {
            return Optional.of(BARE);
        }
        Matcher keyed = KEYED.matcher(path.length() > LONGEST ? "" : path);
        return keyed.matches()
                ? decoded(keyed.group(1))
                        .flatMap(owner -> decoded(keyed.group(2)).map(key -> new RobotWebSocketPath(owner, key)))
                : Optional.empty();
    }

    private static Optional<String> decoded(String part) {
        try {
            return Optional.of(URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }
}
