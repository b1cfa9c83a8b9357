package org.dronemap.ws.soap.xml;

/** Escapes text for XML 1.0, and replaces characters that it cannot carry. */
final class XmlText {
    private static final int UNKNOWN = 0xFFFD;

    private XmlText() {}

    /** {@code quoted}: it may stand between quotation marks. */
    static void append(StringBuilder out, String text, boolean quoted) {
        String plain = plain(text);
        int from = 0;
        for (int i = 0; i < plain.length(); i++) {
            String escaped = escaped(plain.charAt(i), quoted);
            if (!escaped.isEmpty()) {
                out.append(plain, from, i).append(escaped);
                from = i + 1;
            }
        }
        out.append(plain, from, plain.length());
    }

    private static String escaped(char letter, boolean quoted) {
        return switch (letter) {
            case '&' -> "&amp;";
            case '<' -> "&lt;";
            case '>' -> "&gt;";
            case '"' -> quoted ? "&quot;" : "";
            // Readers make a line feed of it, and a blank of any of these within an attribute.
            case '\r' -> "&#xd;";
            case '\n' -> quoted ? "&#xa;" : "";
            case '\t' -> quoted ? "&#x9;" : "";
            default -> "";
        };
    }

    /** Replaces letters that XML 1.0 cannot carry by the sign for that. */
    private static String plain(String text) {
        return isPlain(text)
                ? text
                : text.codePoints()
                        .map(letter -> isCarried(letter) ? letter : UNKNOWN)
                        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                        .toString();
    }

    /** Nearly all texts are: this is looked at first, and quickly. */
    private static boolean isPlain(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (Character.isSurrogate(text.charAt(i)) || !isCarried(text.charAt(i))) {
                return text.codePoints().allMatch(XmlText::isCarried);
            }
        }
        return true;
    }

    private static boolean isCarried(int letter) {
        return (letter >= ' ' && letter < Character.MIN_SURROGATE)
                || (letter > Character.MAX_SURROGATE && letter != 0xFFFE && letter != 0xFFFF)
                || letter == '\t'
                || letter == '\n'
                || letter == '\r';
    }
}
