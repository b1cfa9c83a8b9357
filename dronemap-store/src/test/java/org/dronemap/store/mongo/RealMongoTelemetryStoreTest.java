package org.dronemap.store.mongo;

import com.mongodb.ConnectionString;
import com.mongodb.client.MongoClient;
import com.mongodb.client.MongoClients;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.TelemetryStoreContract;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;

/** The adapter against a real server; what is in the database of that address is dropped before each test. */
@EnabledIfEnvironmentVariable(named = "DRONEMAP_TEST_MONGODB_URI", matches = "mongodb.*")
class RealMongoTelemetryStoreTest extends TelemetryStoreContract {
    private static final String URL = System.getenv().getOrDefault("DRONEMAP_TEST_MONGODB_URI", "");

    private final MongoTelemetryStore adapter = empty();

    private static MongoTelemetryStore empty() {
        ConnectionString url = new ConnectionString(URL);
        String database = url.getDatabase();
        if (database == null || !database.contains("test")) {
            throw new IllegalStateException("DRONEMAP_TEST_MONGODB_URI must name a database with test in its name");
        }
        try (MongoClient client = MongoClients.create(url)) {
            client.getDatabase(database).drop();
        }
        return MongoTelemetryStore.open(URL);
    }

    @Override
    protected TelemetryStore emptyStore() {
        return adapter;
    }

    @AfterEach
    void close() {
        adapter.close();
    }
}
