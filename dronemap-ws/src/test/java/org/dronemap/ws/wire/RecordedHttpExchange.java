package org.dronemap.ws.wire;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * One request that a real client made, and its answer, as a file of the tree: who asked; method and address; headers; an empty
 * line; the body. After the arrow what came of it: status and content type; headers; an empty line; the body.
 */
record RecordedHttpExchange(
        String name, String client, String method, String address, List<String> headers, String body, String answer) {
    private static final String ARROW = "\n=> ";
    private static final Pattern SOAP_LOOK = Pattern.compile("<\\w+:(?:get|list|search)[A-Z]");
    private static final Pattern LINE = Pattern.compile("\n");

    static RecordedHttpExchange read(Path file) {
        String text = ApprovalFiles.read(file);
        int arrow = text.lastIndexOf(ARROW);
        String[] lines = LINE.split(text.substring(0, arrow), -1);
        String[] asked = lines[1].split(" ", 2);
        List<String> headers = new ArrayList<>();
        int at = 2;
        while (!lines[at].isEmpty()) {
            headers.add(lines[at]);
            at++;
        }
        String body = String.join("\n", List.of(lines).subList(at + 1, lines.length));
        return new RecordedHttpExchange(
                String.valueOf(file.getFileName()),
                lines[0],
                asked[0],
                asked[1],
                headers,
                body,
                text.substring(arrow + ARROW.length()));
    }

    /** What the client said. */
    String asked() {
        StringBuilder text = new StringBuilder(client + "\n" + method + " " + address + "\n");
        headers.forEach(header -> text.append(header).append('\n'));
        return text.append('\n').append(body).toString();
    }

    /** The same with another answer, as its file. */
    String saying(String other) {
        return asked() + ARROW + other;
    }

    /** What it asks changes nothing: it may be asked again until it says what is expected. */
    boolean isLook() {
        return method.equals("GET") || SOAP_LOOK.matcher(body).find();
    }

    /** It is answered while an order is still under way. */
    boolean waitsForNothing() {
        return address.startsWith("/api/") && !address.contains("wait=");
    }

    boolean asksForAPlan() {
        return address.endsWith("/plans") || body.contains(":makePlan");
    }
}
