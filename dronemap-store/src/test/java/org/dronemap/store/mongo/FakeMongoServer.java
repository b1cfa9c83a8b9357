package org.dronemap.store.mongo;

import de.bwaldvogel.mongo.MongoServer;
import de.bwaldvogel.mongo.backend.memory.MemoryBackend;
import de.bwaldvogel.mongo.bson.Document;
import de.bwaldvogel.mongo.wire.message.MongoMessage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Speaks MongoDB's wire and keeps documents in memory; knows neither time series nor expiry, but takes down the commands
 * that ask for them.
 */
final class FakeMongoServer implements AutoCloseable {
    private final List<Document> commands = new CopyOnWriteArrayList<>();
    private final MongoServer server = new MongoServer(new Backend());
    private final String url = server.bindAndGetConnectionString();

    private final class Backend extends MemoryBackend {
        @Override
        public Document handleMessage(MongoMessage message) {
            Document command = message.getDocument();
            commands.add(command.clone());
            return command.containsKey("collMod") ? new Document("ok", 1.0) : super.handleMessage(message);
        }
    }

    String url() {
        return url;
    }

    /** All commands of that name, in the order in which they came. */
    List<Document> commands(String name) {
        return commands.stream().filter(command -> command.containsKey(name)).toList();
    }

    @Override
    public void close() {
        server.shutdownNow();
    }
}
