package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.nio.file.Path;
import java.util.List;
import org.dronemap.ws.testserver.DedicatedServers;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.Test;

/** Starting all faces takes longer than most tests: whoever does it for themselves says why, and all together stay few. */
class DedicatedServersTest {
    @Test
    void areStartedByThoseAloneWhoAreListedWithAReason() {
        List<String> starters = tests().stream()
                .filter(DedicatedServersTest::startsServers)
                .map(JavaClass::getSimpleName)
                .toList();

        assertThat(starters)
                .containsExactlyInAnyOrderElementsOf(DedicatedServers.all().stream()
                        .map(DedicatedServers.Own::name)
                        .toList());
    }

    /** Those alone: what they use is none of this. */
    private static JavaClasses tests() {
        return ArchConfiguration.withThreadLocalScope(configuration -> {
            configuration.setResolveMissingDependenciesFromClassPath(false);
            return new ClassFileImporter().importPath(Path.of("target", "test-classes"));
        });
    }

    private static boolean startsServers(JavaClass one) {
        boolean shares = one.isEquivalentTo(SharedServer.class) || one.isEquivalentTo(TestServer.class);
        return !shares
                && one.getConstructorCallsFromSelf().stream()
                        .anyMatch(call -> call.getTargetOwner().isEquivalentTo(TestServer.class));
    }

    @Test
    void areFewInOneRun() {
        int own = DedicatedServers.all().stream()
                .mapToInt(DedicatedServers.Own::starts)
                .sum();

        assertThat(own + DedicatedServers.SHARED).isLessThanOrEqualTo(DedicatedServers.MOST);
        assertThat(DedicatedServers.all())
                .allSatisfy(one -> assertThat(one.why()).isNotBlank());
    }
}
