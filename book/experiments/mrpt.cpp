// A correction by MRPT's Kalman filter, for book/experiments/mrpt.py: reads a problem, prints times and results.
//
// Arguments: file of doubles, repeats. The file: L, m, x (n), P (n, n), variances (3), then for each observation the
// landmark's number, H by the pose (3, 6), H by the landmark (3, 3), measured minus predicted (3).
// Output, a line for each of MRPT's methods: its name, median seconds of the processor in a step, the corrected x (n), P (n, n).
#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

using Base = mrpt::bayes::CKalmanFilterCapable<6, 3, 3, 6, double>;

struct Seen {
    size_t landmark;
    Base::KFMatrix_OxV by_pose;
    Base::KFMatrix_OxF by_point;
    Base::KFArray_OBS difference;
};

struct Problem {
    std::vector<double> x, P;
    double variances[3];
    std::vector<Seen> seen;
};

// The measurement is linear: where the state is still the given one, it is predicted as zero.
class Filter : public Base {
   public:
    explicit Filter(const Problem& p) : problem_(p) {
        const size_t n = p.x.size();
        m_xkk.resize(n);
        m_pkk.setSize(n, n);
        for (size_t i = 0; i < n; i++) {
            m_xkk[i] = p.x[i];
            for (size_t j = 0; j < n; j++) m_pkk(i, j) = p.P[i * n + j];
        }
        place_.assign((n - 6) / 3, -1);
        for (size_t i = 0; i < p.seen.size(); i++) place_[p.seen[i].landmark] = static_cast<int>(i);
    }
    void step() { runOneKalmanIteration(); }

   protected:
    void OnGetAction(KFArray_ACT& u) const override { u.fill(0); }
    void OnTransitionModel(const KFArray_ACT&, KFArray_VEH&, bool& skip) const override { skip = true; }
    void OnTransitionNoise(KFMatrix_VxV& Q) const override { Q.setZero(); }
    void OnGetObservationNoise(KFMatrix_OxO& R) const override {
        for (int i = 0; i < 3; i++) R(i, i) = problem_.variances[i];
    }
    void OnPreComputingPredictions(const vector_KFArray_OBS&, std::vector<size_t>& out) const override {
        out.clear();
        for (const Seen& s : problem_.seen) out.push_back(s.landmark);
    }
    void OnGetObservationsAndDataAssociation(
        vector_KFArray_OBS& z, std::vector<int>& which, const vector_KFArray_OBS&, const KFMatrix&,
        const std::vector<size_t>&, const KFMatrix_OxO&) override {
        z.clear();
        which.clear();
        for (const Seen& s : problem_.seen) {
            z.push_back(s.difference);
            which.push_back(static_cast<int>(s.landmark));
        }
    }
    void OnObservationModel(const std::vector<size_t>& landmarks, vector_KFArray_OBS& out) const override {
        out.resize(landmarks.size());
        for (size_t k = 0; k < landmarks.size(); k++) {
            out[k].fill(0);
            if (place_[landmarks[k]] < 0) continue;
            const Seen& s = problem_.seen[place_[landmarks[k]]];
            const size_t at = 6 + 3 * landmarks[k];
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 6; j++) out[k][i] += s.by_pose(i, j) * (m_xkk[j] - problem_.x[j]);
                for (int j = 0; j < 3; j++) out[k][i] += s.by_point(i, j) * (m_xkk[at + j] - problem_.x[at + j]);
            }
        }
    }
    void OnObservationJacobians(size_t landmark, KFMatrix_OxV& Hx, KFMatrix_OxF& Hy) const override {
        Hx = problem_.seen[place_[landmark]].by_pose;
        Hy = problem_.seen[place_[landmark]].by_point;
    }
    void OnTransitionJacobian(KFMatrix_VxV& F) const override { F.setIdentity(); }

   private:
    const Problem& problem_;
    std::vector<int> place_;
};

static Problem read(const char* path) {
    std::ifstream file(path, std::ios::binary);
    auto next = [&file] { double v = 0; file.read(reinterpret_cast<char*>(&v), sizeof v); return v; };
    Problem p;
    const size_t n = 6 + 3 * static_cast<size_t>(next()), m = static_cast<size_t>(next());
    p.x.resize(n);
    p.P.resize(n * n);
    for (double& v : p.x) v = next();
    for (double& v : p.P) v = next();
    for (double& v : p.variances) v = next();
    p.seen.resize(m);
    for (Seen& s : p.seen) {
        s.landmark = static_cast<size_t>(next());
        for (int i = 0; i < 3; i++) for (int j = 0; j < 6; j++) s.by_pose(i, j) = next();
        for (int i = 0; i < 3; i++) for (int j = 0; j < 3; j++) s.by_point(i, j) = next();
        for (int i = 0; i < 3; i++) s.difference[i] = next();
    }
    return p;
}

int main(int, char** argv) {
    const Problem p = read(argv[1]);
    const std::pair<const char*, mrpt::bayes::TKFMethod> methods[] = {
        {"naive", mrpt::bayes::kfEKFNaive}, {"davison", mrpt::bayes::kfEKFAlaDavison}};
    for (const auto& [name, method] : methods) {
        std::vector<double> seconds, x, P;
        for (int i = 0; i < std::atoi(argv[2]); i++) {
            Filter filter(p);
            filter.KF_options.method = method;
            const std::clock_t began = std::clock();
            filter.step();
            seconds.push_back(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
            x.clear(), P.clear();
            for (size_t a = 0; a < p.x.size(); a++) x.push_back(filter.internal_getXkk()[a]);
            for (size_t a = 0; a < p.x.size(); a++)
                for (size_t b = 0; b < p.x.size(); b++) P.push_back(filter.internal_getPkk()(a, b));
        }
        std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
        std::printf("%s %.9g", name, seconds[seconds.size() / 2]);
        for (double v : x) std::printf(" %.17g", v);
        for (double v : P) std::printf(" %.17g", v);
        std::printf("\n");
    }
}
