package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.Test;

/** The description of REST that programs are written from, to the letter. */
class RestWireTest {
    @Test
    void isDescribedAsApproved() {
        TestServer house = SharedServer.get();
        TestHttpClient.Answer answer = new TestHttpClient(house, "").get("/api/openapi.json");
        assertThat(answer.status()).isEqualTo(200);
        String served = answer.raw().body().replace("http://127.0.0.1:" + house.httpPort(), "http://dronemap.example");

        ApprovalFiles.check("openapi.json", PrettyJson.of(PrettyJson.sorted(PrettyJson.tree(served))));
    }
}
