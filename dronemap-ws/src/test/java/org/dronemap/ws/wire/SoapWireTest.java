package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.Test;

/** The descriptions of SOAP that clients are made from, with all that they import, to the letter. */
class SoapWireTest {
    private static final Pattern IMPORTED = Pattern.compile("[lL]ocation=\"([^\"]*\\?(?:wsdl|xsd)=[^\"]*)\"");

    @Test
    void isDescribedAsApproved() {
        TestServer house = SharedServer.get();
        String here = "http://127.0.0.1:" + house.httpPort();
        TestHttpClient http = new TestHttpClient(house, "");
        Map<String, String> described = new TreeMap<>();
        Deque<String> open = new ArrayDeque<>();
        new ExposedOperations(house).services().forEach(service -> open.add(service + "?wsdl"));
        while (!open.isEmpty()) {
            String path = open.remove();
            TestHttpClient.Answer answer = http.get(path);
            assertThat(answer.status()).as(path).isEqualTo(200);
            String text = answer.raw().body();
            if (described.put(fileOf(path), text.replace(here, "http://dronemap.example") + "\n") == null) {
                Matcher found = IMPORTED.matcher(text);
                while (found.find()) {
                    open.add(found.group(1).replace(here, "").replace("&amp;", "&"));
                }
            }
        }

        assertThat(described).isNotEmpty();
        ApprovalFiles.checkFolder("wsdl", described);
    }

    /** {@code /services/X?wsdl} is {@code X.wsdl}; what it imports has its own name behind. */
    private static String fileOf(String path) {
        String name = path.substring("/services/".length());
        return name.endsWith("?wsdl")
                ? name.replace("?wsdl", ".wsdl")
                : name.replaceFirst("\\?(wsdl|xsd)=", "-").replaceAll("[^A-Za-z0-9.-]", "_");
    }
}
