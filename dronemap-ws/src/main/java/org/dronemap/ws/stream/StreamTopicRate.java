package org.dronemap.ws.stream;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import org.dronemap.ws.stream.delivery.PublishSchedule;

/** Rate at which clients of the WebSocket stream receive updates of each thing of a topic. */
public sealed interface StreamTopicRate {
    /** Nobody misses one: they wait in order, and who lets too many of them wait is closed. */
    record EveryChange() implements StreamTopicRate {
        @Override
        public String words() {
            return "each change, none left out";
        }

        @Override
        public Map<Integer, Collection<StreamClient>> groups(Collection<StreamClient> clients) {
            return Map.of();
        }
    }

    /** Of each thing the newest state, at most so many times a second: 1 to {@value PublishSchedule#MOST_PER_SECOND}. */
    record Newest(int perSecond) implements StreamTopicRate {
        public Newest {
            if (perSecond < 1 || perSecond > PublishSchedule.MOST_PER_SECOND) {
                throw new IllegalArgumentException("A topic is told of 1 to " + PublishSchedule.MOST_PER_SECOND
                        + " times a second, not " + perSecond + " times.");
            }
        }

        @Override
        public String words() {
            return "the newest state, at most " + perSecond + " times a second";
        }

        @Override
        public Map<Integer, Collection<StreamClient>> groups(Collection<StreamClient> clients) {
            return clients.isEmpty() ? Map.of() : Map.of(perSecond, clients);
        }
    }

    /** Of each thing the newest state, as often as each client asked for. */
    record NewestAsAsked() implements StreamTopicRate {
        @Override
        public String words() {
            return "the newest state, as often as was asked for by rate, at most " + PublishSchedule.MOST_PER_SECOND
                    + " times a second";
        }

        @Override
        public Map<Integer, Collection<StreamClient>> groups(Collection<StreamClient> clients) {
            Map<Integer, Collection<StreamClient>> groups = new HashMap<>();
            for (StreamClient client : clients) {
                groups.computeIfAbsent(client.perSecond(), rate -> new ArrayList<>())
                        .add(client);
            }
            return groups;
        }
    }

    /** For people. */
    String words();

    /** Clients by how often a second they are told of a thing whose newest state is sent; without those who miss none. */
    Map<Integer, Collection<StreamClient>> groups(Collection<StreamClient> clients);
}
