package org.dronemap.store.postgres;

import org.dronemap.core.command.CommandStore;
import org.dronemap.store.contract.CommandStoreContract;

class PostgresCommandStoreTest extends CommandStoreContract {
    @Override
    protected CommandStore emptyStore() {
        return SharedDatabase.empty().commands();
    }
}
