package org.dronemap.ws.zone;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about zones. */
final class ZoneStreamTopic {
    private ZoneStreamTopic() {}

    @JsonTypeName("zone")
    @Order(200)
    @Schema(name = "StreamZoneChanged", description = "A zone that was added or changed.")
    record ZoneChanged(ZoneFeature zone) implements StreamMessage.OfUseCase {}

    @JsonTypeName("zoneRemoved")
    @Order(210)
    @Schema(name = "StreamZoneRemoved", description = "A zone that was removed, or is out of your sight from now on.")
    record ZoneRemoved(String id) implements StreamMessage.OfUseCase {}

    static StreamTopic<Zone> of(ZoneRegistry zones) {
        return new StreamTopic<>(
                ZoneChanged.class,
                new StreamTopicRate.EveryChange(),
                new StreamTopic.SubjectMapping<>("zone", Zone::id),
                new StreamTopic.Audience<>(
                        "the organisation that it is of, without those who do not see the drone that it is for; a global one"
                                + " everybody",
                        (who, zone) -> ZoneService.isShownTo(who, zone) ? who.organisation() : null),
                (zone, who) -> new ZoneChanged(ZoneFeature.of(zone, who.organisation())),
                List::of,
                new StreamTopic.Removal(ZoneRemoved.class, ZoneRemoved::new),
                feed -> zones.onChange(change -> publish(feed, change)));
    }

    /** Former forms go together with the new ones. */
    private static void publish(StreamTopicSink<Zone> feed, ZoneRegistry.Change change) {
        Map<String, Zone> put = new LinkedHashMap<>();
        change.put().forEach(zone -> put.put(zone.id(), zone));
        change.former().forEach(former -> feed.publish(former, put.remove(former.id())));
        put.values().forEach(feed::publish);
    }
}
