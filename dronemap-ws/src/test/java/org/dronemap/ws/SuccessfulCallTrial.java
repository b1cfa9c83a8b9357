package org.dronemap.ws;

import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.testserver.AdministrationCalls;
import org.dronemap.ws.testserver.DescribedCalls;
import org.dronemap.ws.testserver.DispatchCalls;
import org.dronemap.ws.testserver.DroneCalls;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.FakeOidcProvider;
import org.dronemap.ws.testserver.FollowCalls;
import org.dronemap.ws.testserver.OrganisationFixture;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecoveryCalls;
import org.dronemap.ws.testserver.RunCalls;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SuccessfulCalls;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** A house in which somebody knows how to do, with success, all that the running server exposes. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class SuccessfulCallTrial {
    private static final Set<String> OWN_FACES = Set.of("rule", "safety", "virtual", "operation", "server");

    private FakeOidcProvider provider;
    TestServer house;
    ExposedOperations faces;
    ScriptedVehicle vehicle;
    OrganisationFixture estate;
    OrganisationMember other;
    List<SuccessfulCalls> deeds;

    @BeforeAll
    void open(@TempDir Path data) {
        provider = new FakeOidcProvider();
        house = new TestServer(
                data,
                TestServer.Options.signingInWith(new OidcSettings(
                        URI.create(provider.issuer()),
                        new OidcSettings.Client(FakeOidcProvider.CLIENT, FakeOidcProvider.SECRET),
                        URI.create("http://localhost/api/v1/session/oidc/callback"),
                        "the stand-in",
                        AccountState.ACTIVE,
                        OidcSettings.Roles.OURS)));
        faces = new ExposedOperations(house);
        vehicle = ScriptedVehicle.connect(house.cloud(), 15_711);
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT16, 1500))));
        estate = new OrganisationFixture(house, "our", OrganisationId.HOME, vehicle);
        other = estate.member("other", Role.OPERATOR);
        deeds = List.of(
                new AdministrationCalls(house, estate.administrator(), provider),
                new DroneCalls(house, estate, other),
                new RunCalls(house, estate),
                new FollowCalls(house, estate),
                new DispatchCalls(house, estate),
                new RecoveryCalls(house, estate),
                new DescribedCalls(house, estate, other));
    }

    @AfterAll
    void close() {
        house.close();
        provider.close();
    }

    /** Ready to be made. */
    final Optional<SuccessfulCalls.PreparedCall> deed(String operation) {
        return deeds.stream().flatMap(one -> one.of(operation).stream()).findFirst();
    }

    /** Of calls; what the server itself decides meanwhile is another thing. */
    final List<AuditEntry> since(int before) {
        List<AuditRecord> all = house.records();
        return all.subList(before, all.size()).stream()
                .map(AuditRecord::entry)
                .filter(entry -> entry.ends() == null && !OWN_FACES.contains(entry.face()))
                .toList();
    }
}
