package org.dronemap.ws.plainhttp;

import io.nayuki.qrcodegen.QrCode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** The page that tells phone users how to trust the server's certificate authority, with QR codes. */
final class PhoneTrustPage {
    private static final int QUIET_ZONE = 3;

    private final String template;
    private final LocalCertificateAuthority authority;
    private final int securePort;

    /** {@code securePort}: where the server speaks TLS. */
    PhoneTrustPage(LocalCertificateAuthority authority, int securePort) throws IOException {
        this.authority = authority;
        this.securePort = securePort;
        try (InputStream in = PhoneTrustPage.class.getResourceAsStream("/door/page.html")) {
            if (in == null) {
                throw new IOException("The page for phones is missing in this build.");
            }
            template = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** For somebody who called the server by that name on that port. */
    String html(String called, int port) {
        String name = authority.nameFor(called);
        String host = name.contains(":") ? "[" + name + "]" : name;
        String here = "http://" + host + ":" + port + "/";
        String page = "https://" + host + ":" + securePort + "/follow";
        return template.replace("{here}", here)
                .replace("{page}", page)
                .replace("{code-here}", code(here))
                .replace("{code-page}", code(page))
                .replace("{fingerprint}", authority.fingerprint());
    }

    /** A picture that a browser draws sharp at any size; its addresses have letters that mean nothing in HTML. */
    private static String code(String text) {
        QrCode code = QrCode.encodeText(text, QrCode.Ecc.MEDIUM);
        StringBuilder path = new StringBuilder();
        for (int y = 0; y < code.size; y++) {
            for (int x = 0; x < code.size; x++) {
                if (code.getModule(x, y)) {
                    path.append('M').append(x).append(',').append(y).append("h1v1h-1z");
                }
            }
        }
        int side = code.size + 2 * QUIET_ZONE;
        return "<svg class=\"code\" role=\"img\" aria-label=\"Code of " + text + "\" viewBox=\"-" + QUIET_ZONE + " -"
                + QUIET_ZONE + " " + side + " " + side + "\" shape-rendering=\"crispEdges\"><path fill=\"#fff\" d=\"M-"
                + QUIET_ZONE + ",-" + QUIET_ZONE + "h" + side + "v" + side + "h-" + side + "z\"/><path d=\"" + path
                + "\"/></svg>";
    }
}
