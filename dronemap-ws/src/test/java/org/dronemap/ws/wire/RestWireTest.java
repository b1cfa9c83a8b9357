package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.ws.house.Http;
import org.dronemap.ws.house.SharedServer;
import org.dronemap.ws.house.TestHouse;
import org.junit.jupiter.api.Test;

/** The description of REST that programs are written from, to the letter. */
class RestWireTest {
    @Test
    void isDescribedAsApproved() {
        TestHouse house = SharedServer.get();
        Http.Answer answer = new Http(house, "").get("/api/openapi.json");
        assertThat(answer.status()).isEqualTo(200);
        String served = answer.raw().body().replace("http://127.0.0.1:" + house.httpPort(), "http://dronemap.example");

        Approved.check("openapi.json", PrettyJson.of(PrettyJson.sorted(PrettyJson.tree(served))));
    }
}
