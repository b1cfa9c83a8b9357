package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PeerCountersTest {
    @Test
    void whatOnePeerCountsIsInTheSumOfItsEndpoint() {
        EndpointCounters endpoint = new EndpointCounters();
        PeerCounters one = new PeerCounters(endpoint);
        PeerCounters other = new PeerCounters(endpoint);
        one.received(5, 7);
        one.lost(3);
        one.lost(-1);
        one.droppedIn();
        one.throttled();
        one.sent(true);
        one.sent(true);
        one.sent(false);
        other.received(10, 0);
        other.sent(true);
        endpoint.peers(2);
        endpoint.refusedPeer();

        assertThat(endpoint.counts()).isEqualTo(new EndpointCounters.Counts(2, 15, 3, 2, 7, 1, 1, 1, 1));
        assertThat(one.framesIn()).isEqualTo(5);
        assertThat(one.framesOut()).isEqualTo(2);
        assertThat(one.lost()).isEqualTo(2);
        assertThat(one.brokenBytes()).isEqualTo(7);
        assertThat(one.dropped()).isEqualTo(3);
    }
}
